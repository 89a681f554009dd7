#pragma once

// The part of the binary interface of libHD that is used here, declared anew: names, types and numbers.

namespace palpate::hd {

using Enum = unsigned int;
using ErrorCode = unsigned int;
using Handle = unsigned int;
using Boolean = unsigned char;
using Schedule = unsigned long;

struct ErrorInfo {
  ErrorCode code;
  int internal;
  Handle device;
};

// Returns kGoOn to be called in the next tick, too.
using Callback = unsigned int (*)(void* user);

constexpr unsigned int kGoOn = 1;
constexpr Handle kNoDevice = 0xFFFF'FFFF;
constexpr unsigned short kHighestPriority = 0xFFFF;

// What can be read and written. Lengths are in millimetres, forces in newtons, torques in newton-millimetres.
constexpr Enum kButtons = 0x2000;          // bits
constexpr Enum kInkwellSwitch = 0x2002;    // false while the stylus is in its inkwell
constexpr Enum kVelocity = 0x2051;         // mm/s
constexpr Enum kTransform = 0x2052;        // base from tool, 4 × 4 by columns
constexpr Enum kAngularVelocity = 0x2053;  // rad/s
constexpr Enum kModel = 0x2501;
constexpr Enum kSerial = 0x2504;
constexpr Enum kUsableWorkspace = 0x2551;    // low corner, high corner
constexpr Enum kInputDegrees = 0x2553;       // 3 or 6
constexpr Enum kOutputDegrees = 0x2554;      // 3 or 6
constexpr Enum kCalibrationStyles = 0x2555;  // bits
constexpr Enum kUpdateRate = 0x2600;         // Hz
constexpr Enum kMaxStiffness = 0x2602;       // N/mm
constexpr Enum kMaxForce = 0x2603;
constexpr Enum kContinuousForce = 0x2604;
constexpr Enum kTemperatures = 0x2605;  // of up to six motors, from 0, cold, to 1, too hot
constexpr Enum kMaxDamping = 0x2609;    // N·s/mm
constexpr Enum kMaxTorque = 0x2622;
constexpr Enum kContinuousTorque = 0x2623;
constexpr Enum kForce = 0x2700;
constexpr Enum kTorque = 0x2701;  // Cartesian; 0x2703 would be that of the joints

// What can be enabled.
constexpr Enum kForceOutput = 0x4000;
constexpr Enum kForceClamping = 0x4001;
constexpr Enum kForceRamping = 0x4002;

constexpr Enum kCalibrated = 0x5000;
constexpr Enum kCalibrationToUpdate = 0x5001;
constexpr Enum kCalibrationByHand = 0x5002;
constexpr int kByEncoderReset = 1;
constexpr int kByItself = 2;
constexpr int kByInkwell = 4;

constexpr ErrorCode kWarmMotors = 0x0200;
constexpr ErrorCode kExceededForce = 0x0201;
constexpr ErrorCode kExceededImpulse = 0x0202;
constexpr ErrorCode kExceededVelocity = 0x0203;
constexpr ErrorCode kForceError = 0x0204;
constexpr ErrorCode kDeviceFault = 0x0300;
constexpr ErrorCode kAlreadyOpen = 0x0301;
constexpr ErrorCode kCommunication = 0x0302;
constexpr ErrorCode kCommunicationSetup = 0x0303;
constexpr ErrorCode kTimer = 0x0304;
constexpr ErrorCode kFrame = 0x0402;
constexpr ErrorCode kLicence = 0x0600;

// Every function: X(result, name, arguments).
#define PALPATE_HD_FUNCTIONS(X)                                          \
  X(Handle, hdInitDevice, (const char*))                                 \
  X(void, hdDisableDevice, (Handle))                                     \
  X(void, hdMakeCurrentDevice, (Handle))                                 \
  X(void, hdBeginFrame, (Handle))                                        \
  X(void, hdEndFrame, (Handle))                                          \
  X(ErrorInfo, hdGetError, (void))                                       \
  X(const char*, hdGetErrorString, (ErrorCode))                          \
  X(void, hdEnable, (Enum))                                              \
  X(void, hdDisable, (Enum))                                             \
  X(void, hdGetDoublev, (Enum, double*))                                 \
  X(void, hdGetIntegerv, (Enum, int*))                                   \
  X(void, hdGetBooleanv, (Enum, Boolean*))                               \
  X(const char*, hdGetString, (Enum))                                    \
  X(void, hdSetDoublev, (Enum, const double*))                           \
  X(Enum, hdCheckCalibration, (void))                                    \
  X(void, hdUpdateCalibration, (Enum))                                   \
  X(void, hdStartScheduler, (void))                                      \
  X(void, hdStopScheduler, (void))                                       \
  X(void, hdSetSchedulerRate, (unsigned long))                           \
  X(Schedule, hdScheduleAsynchronous, (Callback, void*, unsigned short)) \
  X(void, hdUnschedule, (Schedule))

// All of them, as a library has them.
struct Functions {
#define PALPATE_HD_MEMBER(result, name, arguments) result(*name) arguments = nullptr;
  PALPATE_HD_FUNCTIONS(PALPATE_HD_MEMBER)
#undef PALPATE_HD_MEMBER
};

}  // namespace palpate::hd
