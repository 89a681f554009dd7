// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Palpate
{
    /// <summary>How a scene finds its LMDs in each step.</summary>
    public enum Mode
    {
        /// <summary>The complete set, searched from scratch.</summary>
        Global = Raw.PLP_MODE_GLOBAL,

        /// <summary>Local descent from the last search, which is repeated every few steps: new LMDs come late.</summary>
        Descent = Raw.PLP_MODE_DESCENT,

        /// <summary>The complete set, kept up to date with proof as the models move.</summary>
        Certified = Raw.PLP_MODE_CERTIFIED
    }

    /// <summary>What pushes of what is found.</summary>
    public enum Law
    {
        /// <summary>Every LMD is a spring: it jumps where an LMD comes or goes.</summary>
        Springs = Raw.PLP_LAW_SPRINGS,

        /// <summary>Near minima share springs: force and torque are continuous in the pose.</summary>
        Smooth = Raw.PLP_LAW_SMOOTH
    }

    /// <summary>How a scene is made. Only the cutoff must be set.</summary>
    public sealed unsafe class SceneOptions
    {
        internal Raw.plp_scene_options Struct;

        public SceneOptions()
        {
            fixed (Raw.plp_scene_options* options = &Struct)
            {
                Raw.plp_scene_options_init(options, (UIntPtr)sizeof(Raw.plp_scene_options));
            }
        }

        /// <summary>Units of the space, positive: springs begin to push at this distance.</summary>
        public double Cutoff
        {
            get => Struct.cutoff;
            set => Struct.cutoff = value;
        }

        /// <summary>N/m, not negative.</summary>
        public double Stiffness
        {
            get => Struct.stiffness;
            set => Struct.stiffness = value;
        }

        public Mode Mode
        {
            get => (Mode)Struct.mode;
            set => Struct.mode = (int)value;
        }

        public Law Law
        {
            get => (Law)Struct.law;
            set => Struct.law = (int)value;
        }

        /// <summary>N·s/m, not negative: what a spring adds while it closes.</summary>
        public double Damping
        {
            get => Struct.damping;
            set => Struct.damping = value;
        }

        /// <summary>N/m: all springs together are no stiffer in any direction, and a face by itself at most half as stiff.
        /// 0: what the device that holds the tool can render; negative: no cap.</summary>
        public double StiffnessCap
        {
            get => Struct.stiffness_cap;
            set => Struct.stiffness_cap = value;
        }

        /// <summary>Coulomb's coefficient, not negative.</summary>
        public double Friction
        {
            get => Struct.friction;
            set => Struct.friction = value;
        }

        /// <summary>Seconds in which a spring fades that is lost, found late, or hands over from a wall.</summary>
        public double FadeTime
        {
            get => Struct.fade_time;
            set => Struct.fade_time = value;
        }

        /// <summary>Seconds from one step to the next; 0 for 0.001.</summary>
        public double TimeStep
        {
            get => Struct.time_step;
            set => Struct.time_step = value;
        }

        /// <summary>Mode.Descent: steps from one search to the next; 0 for 10.</summary>
        public uint GlobalEvery
        {
            get => Struct.global_every;
            set => Struct.global_every = value;
        }

        /// <summary>Of a step, with the caller's; the outcome does not depend on it.</summary>
        public uint Threads
        {
            get => Struct.threads;
            set => Struct.threads = value;
        }

        /// <summary>Mode.Certified: at most so many tests in a step, which descent then completes; 0: no limit.</summary>
        public uint TickBudget
        {
            get => Struct.tick_budget;
            set => Struct.tick_budget = value;
        }

        /// <summary>List at most so many overlapping pairs.</summary>
        public uint MaxOverlaps
        {
            get => Struct.max_overlaps;
            set => Struct.max_overlaps = value;
        }

        /// <summary>Of poses, points and wrenches of the scene.</summary>
        public Space Space
        {
            get
            {
                fixed (Raw.plp_space* space = &Struct.space)
                {
                    return *(Space*)space;
                }
            }
            set => Struct.space = *(Raw.plp_space*)&value;
        }
    }

    /// <summary>Bodies, one of which is the tool that the hand moves. Any thread may change it; one at a time may step it
    /// and read contacts.</summary>
    public sealed unsafe class Scene : IDisposable
    {
        // Of a glTF file.
        private const int MostNodes = 1000000;

        private readonly SceneHandle handle;
        private readonly Outcome outcome = new Outcome();

        public Scene(SceneOptions options)
        {
            if (options == null)
            {
                throw new ArgumentNullException(nameof(options));
            }
            IntPtr value;
            fixed (Raw.plp_scene_options* how = &options.Struct)
            {
                PalpateException.Check(Raw.plp_scene_create(how, &value));
            }
            handle = new SceneHandle(value);
        }

        /// <summary>For functions of Raw that have no other form here; throws if the scene is disposed.</summary>
        public IntPtr Handle => handle.Value;

        /// <summary>Adds a body; the scene keeps the model.</summary>
        public Body Add(Model model, BodyOptions options = null)
        {
            Raw.plp_body_options copy = (options ?? new BodyOptions()).Struct;
            copy.model = Model.ValueOf(model, nameof(model));
            ulong id;
            PalpateException.Check(Raw.plp_scene_add_body(handle.Value, &copy, &id));
            GC.KeepAlive(model);
            GC.KeepAlive(this);
            return new Body(this, id);
        }

        /// <summary>Adds the nodes of a .gltf or .glb file that have meshes as bodies, parents before children; all or, on
        /// an error, none. Nodes that share a mesh and a scale share a model. Materials come from the file.</summary>
        public Body[] LoadGltf(string path, GltfSceneOptions options = null)
        {
            GltfSceneOptions given = options ?? new GltfSceneOptions();
            Raw.plp_gltf_scene_options how = given.Struct;
            Raw.plp_model_options model = (given.Model ?? new ModelOptions()).Struct;
            how.model = &model;
            byte[] name = Utf8.Bytes(path ?? throw new ArgumentNullException(nameof(path)), nameof(path));
            IntPtr room = Marshal.AllocHGlobal(MostNodes * sizeof(ulong));
            try
            {
                fixed (byte* file = name)
                fixed (byte* tool = Utf8.Bytes(given.Tool, nameof(options)))
                {
                    how.tool = tool;
                    UIntPtr count;
                    Check(Raw.plp_scene_load_gltf(handle.Value, file, &how, (ulong*)room, (UIntPtr)MostNodes, &count));
                    return BodiesOf((ulong*)room, (int)count);
                }
            }
            finally
            {
                Marshal.FreeHGlobal(room);
            }
        }

        /// <summary>The body whose node has this name; of several the first.</summary>
        public Body Find(string name)
        {
            ulong id;
            fixed (byte* text = Utf8.Bytes(name ?? throw new ArgumentNullException(nameof(name)), nameof(name)))
            {
                Check(Raw.plp_scene_find_body(handle.Value, text, &id));
            }
            return new Body(this, id);
        }

        /// <summary>All, in the order in which they were added, as long as none was removed.</summary>
        public Body[] Bodies()
        {
            UIntPtr count;
            Check(Raw.plp_scene_list_bodies(handle.Value, null, UIntPtr.Zero, &count));
            var ids = new ulong[(int)count];
            fixed (ulong* room = ids)
            {
                Check(Raw.plp_scene_list_bodies(handle.Value, room, (UIntPtr)(uint)ids.Length, &count));
                return BodiesOf(room, Math.Min(ids.Length, (int)count));
            }
        }

        /// <summary>Searches the tool against every other body that is near and computes the wrench on it about its
        /// reference point. The same inputs give the same bits.</summary>
        public Contacts Step()
        {
            PalpateException.Check(Raw.plp_scene_step(handle.Value));
            return Read();
        }

        /// <summary>The outcome of the last step, that of a running servo too.</summary>
        public Contacts Read()
        {
            IntPtr scene = handle.Value;
            ++outcome.Generation;
            fixed (Raw.plp_contacts* contacts = &outcome.Struct)
            {
                PalpateException.Check(Raw.plp_scene_get_contacts(scene, contacts));
            }
            GC.KeepAlive(this);
            return new Contacts(outcome);
        }

        public void SetCutoff(double cutoff) => Check(Raw.plp_scene_set_cutoff(handle.Value, cutoff));

        /// <summary>N/m of bodies that have none of their own.</summary>
        public void SetStiffness(double stiffness) => Check(Raw.plp_scene_set_stiffness(handle.Value, stiffness));

        public void SetLaw(Law law) => Check(Raw.plp_scene_set_law(handle.Value, (int)law));

        /// <summary>N·s/m of a closing spring, of bodies that have none of their own.</summary>
        public void SetDamping(double damping) => Check(Raw.plp_scene_set_damping(handle.Value, damping));

        /// <summary>N/m of all springs together; 0: what the device can render; negative: no cap.</summary>
        public void SetStiffnessCap(double cap) => Check(Raw.plp_scene_set_stiffness_cap(handle.Value, cap));

        public void SetFriction(double friction) => Check(Raw.plp_scene_set_friction(handle.Value, friction));

        public void SetMode(Mode mode) => Check(Raw.plp_scene_set_mode(handle.Value, (int)mode));

        /// <summary>Gives the tool to a device, whose hand feels it in every step from then on; null takes it away. The
        /// scene keeps the device.</summary>
        public void SetDevice(Device device, DeviceMapping mapping = null)
        {
            Raw.plp_device_mapping copy = (mapping ?? new DeviceMapping()).Struct;
            Check(Raw.plp_scene_set_device(handle.Value, device == null ? IntPtr.Zero : device.Handle, &copy));
            GC.KeepAlive(device);
        }

        /// <summary>Starts a servo: native threads step and search the scene, and call nothing managed. Bodies and
        /// settings may be changed meanwhile; Read() gives the newest outcome.</summary>
        public void Start(ServoOptions options = default(ServoOptions))
        {
            Raw.plp_servo_options copy = options.Struct;
            Check(Raw.plp_scene_start(handle.Value, &copy));
        }

        /// <summary>Stops the servo, if one runs, and waits until it rests.</summary>
        public void Stop() => Check(Raw.plp_scene_stop(handle.Value));

        /// <summary>How the servo runs or, if it was stopped, ran. Allocates nothing.</summary>
        public ServoState Servo
        {
            get
            {
                Raw.plp_servo_state state;
                Raw.plp_servo_state_init(&state, (UIntPtr)sizeof(Raw.plp_servo_state));
                Check(Raw.plp_scene_get_servo(handle.Value, &state));
                return new ServoState(state);
            }
        }

        /// <summary>Records every step from now on into a file that Trace reads, a servo's too, which never waits for it.
        /// The end of the scene finishes the file.</summary>
        public void Record(string path)
        {
            fixed (byte* name = Utf8.Bytes(path ?? throw new ArgumentNullException(nameof(path)), nameof(path)))
            {
                Check(Raw.plp_scene_record(handle.Value, name));
            }
        }

        /// <summary>Finishes the file and tells what is in it; throws if it could not be written whole.</summary>
        public Recording StopRecording()
        {
            Raw.plp_recording recording;
            Raw.plp_recording_init(&recording, (UIntPtr)sizeof(Raw.plp_recording));
            Check(Raw.plp_scene_stop_recording(handle.Value, &recording));
            return new Recording(recording);
        }

        /// <summary>How the recording goes. Allocates nothing.</summary>
        public Recording Recording
        {
            get
            {
                Raw.plp_recording recording;
                Raw.plp_recording_init(&recording, (UIntPtr)sizeof(Raw.plp_recording));
                Check(Raw.plp_scene_get_recording(handle.Value, &recording));
                return new Recording(recording);
            }
        }

        public void Dispose()
        {
            ++outcome.Generation;
            handle.Dispose();
        }

        private Body[] BodiesOf(ulong* ids, int count)
        {
            var bodies = new Body[count];
            for (int i = 0; i < count; ++i)
            {
                bodies[i] = new Body(this, ids[i]);
            }
            return bodies;
        }

        /// <summary>Of a call with this scene's handle, which it keeps alive until then.</summary>
        internal void Check(int result)
        {
            GC.KeepAlive(this);
            PalpateException.Check(result);
        }
    }
}
