// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using UnityEngine;

namespace Palpate.Unity
{
    /// <summary>Bodies, a tool, and the forces between them. A native thread steps it a thousand times a second beside
    /// Unity, which looks at the newest outcome once a frame; no managed code ever runs on that thread.</summary>
    [AddComponentMenu("Palpate/Palpate Scene")]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(-100)]
    public sealed class PalpateScene : MonoBehaviour
    {
        [Tooltip("Units of Unity: springs begin to push at this distance")]
        [Min(1e-6f)]
        public float cutoff = 0.01f;

        [Tooltip("N/m")]
        [Min(0)]
        public float stiffness = 500;

        [Tooltip("N·s/m of a closing spring")]
        [Min(0)]
        public float damping;

        [Tooltip("N/m of all springs together; 0: what the device can render; negative: no cap")]
        public float stiffnessCap;

        [Tooltip("Coulomb's coefficient")]
        [Min(0)]
        public float friction;

        public Law law = Law.Smooth;
        public Mode mode = Mode.Certified;

        [Tooltip("How models came into Unity's left-handed world")]
        public Handedness handedness = Handedness.FlipX;

        [Tooltip("Metres in a unit of Unity")]
        [Min(1e-9f)]
        public float metresPerUnit = 1;

        [Tooltip("Step it on a native thread; otherwise in FixedUpdate, which is too slow for a hand")]
        public bool servo = true;

        [Tooltip("Steps of the servo in a second")]
        [Range(1, 20000)]
        public int servoRate = 1000;

        private static readonly List<PalpateScene> Enabled = new List<PalpateScene>();
        private static readonly List<HapticBody> Bodies = new List<HapticBody>();
        private static readonly List<HapticDevice> Devices = new List<HapticDevice>();

        private readonly List<HapticBody> bodies = new List<HapticBody>();
        private Contact[] contacts = new Contact[64];
        private Scene native;
        private ModelSource models;
        private HapticTool tool;
        private HapticDevice device;

        /// <summary>Of the newest outcome: a plateau's points one by one.</summary>
        public int ContactCount { get; private set; }

        /// <summary>On the tool, newtons.</summary>
        public Vector3 Force { get; private set; }

        /// <summary>On the tool about its reference point, newton-metres.</summary>
        public Vector3 Torque { get; private set; }

        /// <summary>Whether surfaces touch or cross.</summary>
        public bool Overlap { get; private set; }

        public Status Status { get; private set; }

        /// <summary>Infinite if nothing is near; units of Unity.</summary>
        public float MinDistance { get; private set; } = float.PositiveInfinity;

        /// <summary>How the native thread runs; only while the component is enabled.</summary>
        public ServoState Servo => native.Servo;

        /// <summary>For what has no form here; null while the component is disabled.</summary>
        public Scene Native => native;

        public HapticTool Tool => tool;

        /// <summary>Records every step from now on, which Trace reads and `palpate run` replays, until StopRecording or the
        /// component's end. Only while it is enabled.</summary>
        /// <param name="path">Such as Path.Combine(Application.persistentDataPath, "session.trace").</param>
        public void StartRecording(string path) => Running.Record(path);

        /// <summary>Finishes the file and tells what is in it.</summary>
        public Recording StopRecording() => Running.StopRecording();

        private Scene Running => native ?? throw new InvalidOperationException($"{name} is disabled.");

        public Contact GetContact(int index)
        {
            if ((uint)index >= (uint)ContactCount)
            {
                throw new ArgumentOutOfRangeException(nameof(index));
            }
            return contacts[index];
        }

        internal static void Register(HapticBody body)
        {
            Bodies.Add(body);
            PalpateScene scene = SceneFor(body.Wanted);
            if (scene != null)
            {
                scene.Add(body);
            }
        }

        internal static void Unregister(HapticBody body)
        {
            Bodies.Remove(body);
            if (body.IsAdded)
            {
                body.Owner.RemoveBody(body);
            }
        }

        internal static void Register(HapticDevice device)
        {
            Devices.Add(device);
            PalpateScene scene = SceneFor(device.Wanted);
            if (scene != null)
            {
                scene.Take(device);
            }
        }

        internal static void Unregister(HapticDevice device)
        {
            Devices.Remove(device);
            foreach (PalpateScene scene in Enabled)
            {
                scene.Release(device);
            }
        }

        /// <summary>Unity may keep native threads and static fields from one play session to the next.</summary>
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void BeginSession()
        {
            Library.ShutDownAll();
            Enabled.Clear();
            Bodies.Clear();
            Devices.Clear();
        }

        private static PalpateScene SceneFor(PalpateScene wanted)
        {
            if (wanted != null)
            {
                return wanted.native == null ? null : wanted;
            }
            return Enabled.Count == 0 ? null : Enabled[Enabled.Count - 1];
        }

        private void OnEnable()
        {
            Space space = Conversion.SpaceOf(handedness, metresPerUnit);
            try
            {
                native = new Scene(new SceneOptions
                {
                    Cutoff = cutoff, Stiffness = stiffness, Damping = damping, StiffnessCap = stiffnessCap,
                    Friction = friction, Law = law, Mode = mode, Space = space,
                    TimeStep = servo ? 1.0 / servoRate : Time.fixedDeltaTime
                });
            }
            catch (PalpateException error)
            {
                Debug.LogError($"{name}: {error.Message}", this);
                return;
            }
            models = new ModelSource(space);
            Enabled.Add(this);
            foreach (HapticBody body in Bodies)
            {
                if (!body.IsAdded && SceneFor(body.Wanted) == this)
                {
                    Add(body);
                }
            }
            foreach (HapticDevice waiting in Devices)
            {
                if (SceneFor(waiting.Wanted) == this)
                {
                    Take(waiting);
                }
            }
            if (servo)
            {
                native.Start(new ServoOptions { Rate = servoRate });
            }
        }

        private void OnDisable()
        {
            if (native == null)
            {
                return;
            }
            Enabled.Remove(this);
            native.Stop();
            native.Dispose();
            native = null;
            models.Dispose();
            models = null;
            foreach (HapticBody body in bodies)
            {
                body.Forget();
            }
            bodies.Clear();
            tool = null;
            device = null;
            Clear();
        }

        /// <summary>What is changed in the inspector is felt at once.</summary>
        private void OnValidate()
        {
            if (native == null)
            {
                return;
            }
            native.SetCutoff(cutoff);
            native.SetStiffness(stiffness);
            native.SetDamping(damping);
            native.SetStiffnessCap(stiffnessCap);
            native.SetFriction(friction);
            native.SetLaw(law);
            native.SetMode(mode);
        }

        private void FixedUpdate()
        {
            if (native != null && !servo)
            {
                native.Step();
            }
        }

        private void Update()
        {
            if (native == null)
            {
                return;
            }
            foreach (HapticBody body in bodies)
            {
                body.Follow();
            }
            Read(native.Read());
        }

        private void Add(HapticBody body)
        {
            if (!body.AddTo(this, native, models))
            {
                return;
            }
            bodies.Add(body);
            HapticTool added = body as HapticTool;
            if (added != null)
            {
                tool = added;
                tool.PutInHand(device != null);
            }
        }

        private void RemoveBody(HapticBody body)
        {
            bodies.Remove(body);
            body.Remove();
            if (ReferenceEquals(body, tool))
            {
                tool = null;
            }
        }

        private void Take(HapticDevice taken)
        {
            try
            {
                native.SetDevice(taken.Native, taken.Mapping());
            }
            catch (PalpateException error)
            {
                Debug.LogError($"{taken.name}: {error.Message}", taken);
                return;
            }
            device = taken;
            if (tool != null)
            {
                tool.PutInHand(true);
            }
        }

        private void Release(HapticDevice released)
        {
            if (!ReferenceEquals(device, released))
            {
                return;
            }
            native.SetDevice(null);
            device = null;
            if (tool != null)
            {
                tool.PutInHand(false);
            }
        }

        private void Read(Contacts outcome)
        {
            Wrench wrench = outcome.Wrench;
            Force = Conversion.ToUnity(wrench.Force);
            Torque = Conversion.ToUnity(wrench.Torque);
            Overlap = outcome.Overlap;
            Status = outcome.Status;
            MinDistance = (float)outcome.MinDistance;
            if (outcome.Lmds.Count > contacts.Length)
            {
                contacts = new Contact[2 * outcome.Lmds.Count];
            }
            ContactCount = outcome.Lmds.CopyTo(contacts);
        }

        private void Clear()
        {
            ContactCount = 0;
            Force = Torque = Vector3.zero;
            Overlap = false;
            Status = Status.None;
            MinDistance = float.PositiveInfinity;
        }

        private void OnDrawGizmos()
        {
            for (int i = 0; i < ContactCount; ++i)
            {
                Vector3 from = Conversion.ToUnity(contacts[i].PointA);
                Vector3 to = Conversion.ToUnity(contacts[i].PointB);
                Gizmos.color = Color.Lerp(Color.red, Color.yellow, (float)contacts[i].Distance / cutoff);
                Gizmos.DrawLine(from, to);
                Gizmos.DrawSphere(from, 0.03f * cutoff);
            }
            if (tool != null)
            {
                // As long as the cutoff at full stiffness.
                Gizmos.color = Color.cyan;
                Gizmos.DrawRay(tool.transform.position, Force / Mathf.Max(stiffness * metresPerUnit, 1e-6f));
            }
        }
    }
}
