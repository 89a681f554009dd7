// SPDX-License-Identifier: MIT
using UnityEngine;

namespace Palpate.Unity
{
    /// <summary>A device whose handle holds the tool of the PalpateScene above it, or of the one that was enabled last. Its
    /// transform is where the device stands in the world. It begins disarmed: arm it with the hand on the handle.
    /// </summary>
    [AddComponentMenu("Palpate/Haptic Device")]
    [DisallowMultipleComponent]
    public sealed class HapticDevice : MonoBehaviour
    {
        [Tooltip("Such as sim:premium6dof or sim:touch; `palpate devices` lists what there is")]
        public string uri = "sim:premium6dof";

        [Tooltip("Units of the scene, in metres, for a metre of the handle")]
        [Min(1e-6f)]
        public float motionScale = 1;

        [Tooltip("Newtons on the hand for a newton on the tool")]
        [Min(0)]
        public float forceScale = 1;

        [Tooltip("Bits of buttons: while all are held the handle moves without the tool; 0: none")]
        public int clutchButtons;

        [Tooltip("Take the tool up where it is, rather than moving it into the hand")]
        public bool keepToolPose = true;

        [Tooltip("N, tighter than the device's own; 0: the device's own")]
        [Min(0)]
        public float maxForce;

        [Tooltip("Bits of buttons that must all be held for any force; 0: none")]
        public int deadMan;

        [Header("Only for a simulated device")]
        public Grip grip = Grip.Light;

        public HandScript hand = HandScript.Hold;

        [Tooltip("m along the script's direction, -y of the device")]
        public float depth = 0.01f;

        [Tooltip("m")]
        public float travel = 0.02f;

        [Tooltip("s")]
        [Min(0.001f)]
        public float period = 1;

        private Device device;

        /// <summary>Whether it could be opened.</summary>
        public bool IsOpen => device != null;

        /// <summary>Of the last tick; only while it is open.</summary>
        public DeviceState State => device.State;

        /// <summary>Only while it is open.</summary>
        public DeviceInfo Info => device.Info;

        public void Arm()
        {
            if (IsOpen)
            {
                device.Arm();
            }
        }

        public void Disarm()
        {
            if (IsOpen)
            {
                device.Disarm();
            }
        }

        internal Device Native => device;

        internal PalpateScene Wanted => GetComponentInParent<PalpateScene>();

        internal DeviceMapping Mapping() => new DeviceMapping
        {
            SceneFromBase = Conversion.PoseOf(transform), MotionScale = motionScale, ForceScale = forceScale,
            ClutchButtons = (uint)clutchButtons, KeepToolPose = keepToolPose
        };

        private void OnEnable()
        {
            try
            {
                device = Device.Open(uri);
                device.SetLimits(new SafetyLimits { MaxForce = maxForce, DeadMan = (uint)deadMan });
                if (uri.StartsWith("sim:", System.StringComparison.Ordinal))
                {
                    device.SetHand(new Hand { Grip = grip, Script = hand, Depth = depth, Travel = travel, Period = period });
                }
            }
            catch (PalpateException error)
            {
                Debug.LogError($"{name}: {error.Message}", this);
                Close();
                return;
            }
            PalpateScene.Register(this);
        }

        private void OnDisable()
        {
            PalpateScene.Unregister(this);
            Close();
        }

        private void Close()
        {
            if (device != null)
            {
                device.Disarm();
                device.Dispose();
                device = null;
            }
        }
    }
}
