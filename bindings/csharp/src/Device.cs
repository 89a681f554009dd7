// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Palpate
{
    /// <summary>A haptic device in its safety limits, which nothing removes. It begins disarmed: arm it with the hand on
    /// the handle and the face away. Any thread may use it. A scene keeps its device.</summary>
    public sealed unsafe class Device : IDisposable
    {
        private readonly DeviceHandle handle;

        private Device(IntPtr value)
        {
            handle = new DeviceHandle(value);
        }

        /// <summary>The devices that could be opened now, and the ways to devices that are missing something.</summary>
        public static DeviceInfo[] List()
        {
            UIntPtr count;
            PalpateException.Check(Raw.plp_device_list(null, UIntPtr.Zero, &count));
            var structs = new Raw.plp_device_info[Math.Max(1, checked((int)count))];
            fixed (Raw.plp_device_info* infos = structs)
            {
                infos[0].struct_size = (uint)sizeof(Raw.plp_device_info);
                PalpateException.Check(Raw.plp_device_list(infos, (UIntPtr)structs.Length, &count));
            }
            var devices = new DeviceInfo[Math.Min(structs.Length, checked((int)count))];
            for (int i = 0; i < devices.Length; ++i)
            {
                devices[i] = new DeviceInfo(structs[i]);
            }
            return devices;
        }

        /// <summary>Opens one of List(), or a simulated PHANToM.</summary>
        public static Device Open(string uri = "sim:premium6dof")
        {
            IntPtr value;
            fixed (byte* text = Utf8.Bytes(uri, nameof(uri)))
            {
                PalpateException.Check(Raw.plp_device_open(text, &value));
            }
            return new Device(value);
        }

        /// <summary>For functions of Raw that have no other form here; throws if the device is disposed.</summary>
        public IntPtr Handle => handle.Value;

        public DeviceInfo Info
        {
            get
            {
                Raw.plp_device_info info;
                Raw.plp_device_info_init(&info, (UIntPtr)sizeof(Raw.plp_device_info));
                Check(Raw.plp_device_get_info(handle.Value, &info));
                return new DeviceInfo(info);
            }
        }

        /// <summary>Of its last tick: a step of the scene that has it. Allocates nothing.</summary>
        public DeviceState State
        {
            get
            {
                Raw.plp_device_state state;
                Raw.plp_device_state_init(&state, (UIntPtr)sizeof(Raw.plp_device_state));
                Check(Raw.plp_device_get_state(handle.Value, &state));
                return new DeviceState(state);
            }
        }

        /// <summary>Lets force fade in from the next tick on.</summary>
        public void Arm() => Check(Raw.plp_device_arm(handle.Value));

        /// <summary>Tells a device that needs it that its handle is now where its maker wants it for
        /// calibration.</summary>
        public void Calibrate() => Check(Raw.plp_device_calibrate(handle.Value));

        /// <summary>Ends all force from the next tick on, at once.</summary>
        public void Disarm() => Check(Raw.plp_device_disarm(handle.Value));

        /// <summary>Tightens the limits, from the device's own and not from those before.</summary>
        public void SetLimits(SafetyLimits limits)
        {
            Raw.plp_safety_limits copy = (limits ?? throw new ArgumentNullException(nameof(limits))).Struct;
            Check(Raw.plp_device_set_limits(handle.Value, &copy));
        }

        /// <summary>Tells a simulated hand how to hold and what to do from the next tick on.</summary>
        public void SetHand(Hand hand)
        {
            Raw.plp_hand_options copy = (hand ?? throw new ArgumentNullException(nameof(hand))).Struct;
            Check(Raw.plp_device_set_hand(handle.Value, &copy));
        }

        /// <summary>Lets a simulated hand follow recorded poses; the times grow, in seconds.</summary>
        public void SetHandPoses(ReadOnlySpan<double> times, ReadOnlySpan<Pose> poses)
        {
            if (times.Length != poses.Length)
            {
                throw new ArgumentException($"{times.Length} times for {poses.Length} poses", nameof(poses));
            }
            fixed (double* seconds = &MemoryMarshal.GetReference(times))
            fixed (Pose* places = &MemoryMarshal.GetReference(poses))
            {
                Check(Raw.plp_device_set_hand_poses(handle.Value, seconds, (Raw.plp_pose*)places, (UIntPtr)times.Length));
            }
        }

        /// <summary>Moves the handle at once to where the simulated hand wants it.</summary>
        public void PlaceInHand() => Check(Raw.plp_device_place_in_hand(handle.Value));

        public void Dispose() => handle.Dispose();

        private void Check(int result)
        {
            GC.KeepAlive(this);
            PalpateException.Check(result);
        }
    }
}
