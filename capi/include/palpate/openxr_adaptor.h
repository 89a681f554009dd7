/* SPDX-License-Identifier: MIT */
/**
 * @file openxr_adaptor.h
 * @brief Palpate in a program that has an OpenXR session: pure functions between the two; compiles as C99 and
 * as C++17, without OpenXR's headers. Link the mathematics library.
 *
 * OpenXR gives poses 72 to 120 times a second and takes vibrations, no wrenches. The host keeps the session
 * and, in each frame,
 *
 *   1. turns the controller's pose for the predicted time into the hand's pose: plp_openxr_pose_in;
 *   2. takes, some times over, a pose between the last hand and this one (plp_openxr_between), lets the tool
 * follow it (plp_openxr_follow), gives the tool that pose (plp_scene_set_pose), steps and reads the wrench;
 *   3. draws the tool where it came to: plp_openxr_pose_out. It stays outside of what the hand goes into;
 *   4. hands what plp_openxr_vibrate says to xrApplyHapticFeedback, or stops it, and what plp_openxr_curl
 * says to a glove.
 *
 * Palpate's own space is OpenXR's: right-handed, +y up, metres. Angles are radians, times seconds. All
 * functions are of thread safety `servo`: they depend on their arguments alone.
 */
#ifndef PALPATE_OPENXR_ADAPTOR_H
#define PALPATE_OPENXR_ADAPTOR_H

#include <math.h>
#include <palpate/palpate.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------ poses */

/** As XrPosef: orientation x y z w, then position; copy one into the other. */
typedef struct plp_openxr_pose {
  float orientation[4]; /**< quaternion x y z w */
  float position[3];    /**< metres */
} plp_openxr_pose;

/** @brief The product a·b of two quaternions, b first. @since 0.1 */
static inline void plp_openxr_multiply(const double a[4], const double b[4], double product[4]) {
  const double x = a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1];
  const double y = a[3] * b[1] + a[1] * b[3] + a[2] * b[0] - a[0] * b[2];
  const double z = a[3] * b[2] + a[2] * b[3] + a[0] * b[1] - a[1] * b[0];
  const double w = a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2];
  product[0] = x;
  product[1] = y;
  product[2] = z;
  product[3] = w;
}

/** @brief The quaternion that turns about `rotation` by its length in radians. @since 0.1 */
static inline void plp_openxr_turn(const double rotation[3], double quaternion[4]) {
  const double squared = rotation[0] * rotation[0] + rotation[1] * rotation[1] + rotation[2] * rotation[2];
  const double angle = sqrt(squared);
  const double scale = angle > 1e-9 ? sin(0.5 * angle) / angle : 0.5;
  int i;
  for (i = 0; i < 3; ++i) quaternion[i] = scale * rotation[i];
  quaternion[3] = cos(0.5 * angle);
}

/** @brief The rotation about a vector, by its length of at most π, that turns `from` into `to`, both of unit
 * length. @since 0.1 */
static inline void plp_openxr_rotation_between(const double from[4], const double to[4], double rotation[3]) {
  const double inverse[4] = {-from[0], -from[1], -from[2], from[3]};
  double turn[4], sine, scale;
  int i;
  plp_openxr_multiply(to, inverse, turn);
  sine = sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]);
  scale = sine > 1e-9 ? 2 * atan2(sine, fabs(turn[3])) / sine : 2;
  for (i = 0; i < 3; ++i) rotation[i] = (turn[3] < 0 ? -scale : scale) * turn[i];
}

/**
 * @brief The hand's pose from one that OpenXR located.
 * @param located of the controller's grip, in the space that the scene is in. @param pose receives it with
 * its orientation normalised; untouched if there is none.
 * @return 1; 0 if a number is not finite or the orientation is zero, as of a controller that was never seen.
 * Whether the pose is tracked is in XrSpaceLocation::locationFlags.
 * @since 0.1
 */
static inline int plp_openxr_pose_in(const plp_openxr_pose* located, plp_pose* pose) {
  double squared = 0, sum = 0;
  int i;
  for (i = 0; i < 4; ++i) squared += (double)located->orientation[i] * located->orientation[i];
  for (i = 0; i < 3; ++i) sum += fabs((double)located->position[i]);
  if (!(squared > 1e-12 && squared < 1e12 && sum < 1e15)) return 0;
  for (i = 0; i < 4; ++i) pose->orientation[i] = located->orientation[i] / sqrt(squared);
  for (i = 0; i < 3; ++i) pose->position[i] = located->position[i];
  return 1;
}

/** @brief A pose to draw with. @since 0.1 */
static inline plp_openxr_pose plp_openxr_pose_out(const plp_pose* pose) {
  plp_openxr_pose drawn;
  int i;
  for (i = 0; i < 4; ++i) drawn.orientation[i] = (float)pose->orientation[i];
  for (i = 0; i < 3; ++i) drawn.position[i] = (float)pose->position[i];
  return drawn;
}

/** @brief The pose at `fraction` of the way from one to another: straight on, and turning evenly the shorter
 * way round. @param from and @param to have orientations of unit length. @since 0.1 */
static inline plp_pose plp_openxr_between(const plp_pose* from, const plp_pose* to, double fraction) {
  plp_pose pose;
  double rotation[3], turn[4];
  int i;
  plp_openxr_rotation_between(from->orientation, to->orientation, rotation);
  for (i = 0; i < 3; ++i) {
    rotation[i] *= fraction;
    pose.position[i] = from->position[i] + fraction * (to->position[i] - from->position[i]);
  }
  plp_openxr_turn(rotation, turn);
  plp_openxr_multiply(turn, from->orientation, pose.orientation);
  return pose;
}

/* --------------------------------------------------------------------------------------- the tool follows */

/** How a tool without mass hangs on the hand: springs draw it there, dampers hold it back. */
typedef struct plp_openxr_grip {
  double stiffness;         /**< N/m */
  double drag;              /**< N·s/m: more than dt × the stiffness of all contacts together */
  double angular_stiffness; /**< N·m/rad */
  double angular_drag;      /**< N·m·s/rad: likewise, for that about the tool's origin */
} plp_openxr_grip;

/** @brief A light grip for contacts of 1000 N/m and steps of 1 ms: 200 N/m, 4 N·s/m, 0.5 N·m/rad and 0.01
 * N·m·s/rad. @since 0.1 */
static inline plp_openxr_grip plp_openxr_grip_light(void) {
  const plp_openxr_grip grip = {200, 4, 0.5, 0.01};
  return grip;
}

/**
 * @brief Where the tool comes to in `dt` seconds: drawn to the hand, and pushed by the last step's wrench. It
 * rests where both are equal, so that `stiffness` × what the hand is ahead is the force.
 * @param wrench on the tool about its origin: plp_contacts::wrench with no reference point. One that is not
 * finite counts as none. @param dt positive.
 * @return the pose for plp_scene_set_pose, of unit orientation.
 * @since 0.1
 */
static inline plp_pose plp_openxr_follow(const plp_openxr_grip* grip, const plp_pose* hand,
                                         const plp_pose* tool, const plp_wrench* wrench, double dt) {
  /* Implicit in the hand's springs, so that no grip is too stiff. */
  const double a = dt / grip->drag, b = dt / grip->angular_drag;
  plp_pose moved;
  double rotation[3], turn[4], length = 0, sum = 0;
  int i, finite;
  for (i = 0; i < 3; ++i) sum += fabs(wrench->force[i]) + fabs(wrench->torque[i]);
  finite = sum <= 1e300;
  plp_openxr_rotation_between(tool->orientation, hand->orientation, rotation);
  for (i = 0; i < 3; ++i) {
    const double pull = grip->stiffness * (hand->position[i] - tool->position[i]);
    const double force = pull + (finite ? wrench->force[i] : 0);
    const double torque = grip->angular_stiffness * rotation[i] + (finite ? wrench->torque[i] : 0);
    moved.position[i] = tool->position[i] + a * force / (1 + a * grip->stiffness);
    rotation[i] = b * torque / (1 + b * grip->angular_stiffness);
  }
  plp_openxr_turn(rotation, turn);
  plp_openxr_multiply(turn, tool->orientation, moved.orientation);
  for (i = 0; i < 4; ++i) length += moved.orientation[i] * moved.orientation[i];
  for (i = 0; i < 4; ++i) moved.orientation[i] /= sqrt(length);
  return moved;
}

/* ---------------------------------------------------------------------------------------------- vibration */

/** How contacts are made into vibration. */
typedef struct plp_openxr_vibration_options {
  double full_force;     /**< N that vibrate with amplitude 1 */
  double full_torque;    /**< N·m that do; what asks for more counts */
  double frequency;      /**< Hz while in contact; 0: the runtime's choice */
  double tick_amplitude; /**< 0 to 1, of the tick when contact begins */
  double tick_frequency; /**< Hz */
  double tick_duration;  /**< s */
  double hold;           /**< s that a vibration goes on if the host says no more: a few frames */
} plp_openxr_vibration_options;

/** @brief 5 N, 0.2 N·m, the runtime's frequency; a tick of 0.8 at 200 Hz for 0.012 s; held for 0.05 s. @since
 * 0.1 */
static inline plp_openxr_vibration_options plp_openxr_vibration_defaults(void) {
  const plp_openxr_vibration_options options = {5, 0.2, 0, 0.8, 200, 0.012, 0.05};
  return options;
}

/** What is remembered from one frame to the next; begin with zeros. */
typedef struct plp_openxr_touch {
  int32_t touching;  /**< 1: something pushes or overlaps */
  int32_t reserved;  /**< 0 */
  double tick_until; /**< s: the tick goes on until then */
} plp_openxr_touch;

/** For XrHapticVibration. Amplitude 0: call xrStopHapticFeedback instead. */
typedef struct plp_openxr_vibration {
  int64_t duration; /**< ns, as XrDuration */
  float frequency;  /**< Hz; 0 is XR_FREQUENCY_UNSPECIFIED */
  float amplitude;  /**< 0 to 1 */
} plp_openxr_vibration;

/** @brief The part of 1 that `wrench` asks for; 0 for one that is not finite. @since 0.1 */
static inline double plp_openxr_amplitude(const plp_openxr_vibration_options* options,
                                          const plp_wrench* wrench) {
  const double* f = wrench->force;
  const double* t = wrench->torque;
  const double force = sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]) / options->full_force;
  const double torque = sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]) / options->full_torque;
  if (!(force <= 1e300 && torque <= 1e300)) return 0;
  return fmin(1, fmax(force, torque));
}

/**
 * @brief What to vibrate with in this frame: a tick where contact begins, then as strongly as the wrench
 * pushes, and nothing without contact.
 * @param touch is changed. @param contacts of the last step; null while the controller is not tracked, which
 * ends everything at once. @param now s, of any clock that grows.
 * @since 0.1
 */
static inline plp_openxr_vibration plp_openxr_vibrate(const plp_openxr_vibration_options* options,
                                                      plp_openxr_touch* touch, const plp_contacts* contacts,
                                                      double now) {
  const int touching =
      contacts && (contacts->set_count > 0 || contacts->spring_count > 0 || contacts->overlap);
  plp_openxr_vibration vibration = {0, 0, 0};
  double amplitude, seconds = options->hold;
  if (touching && !touch->touching) touch->tick_until = now + options->tick_duration;
  touch->touching = touching;
  if (!touching) {
    touch->tick_until = now;
    return vibration;
  }
  amplitude = plp_openxr_amplitude(options, &contacts->wrench);
  vibration.frequency = (float)options->frequency;
  if (now < touch->tick_until && amplitude < options->tick_amplitude) {
    amplitude = options->tick_amplitude;
    seconds = touch->tick_until - now;
    vibration.frequency = (float)options->tick_frequency;
  }
  vibration.amplitude = (float)amplitude;
  vibration.duration = (int64_t)(1e9 * seconds + 0.5);
  return vibration;
}

/* ------------------------------------------------------------------------------------------------- gloves */

/**
 * @brief How far a glove holds a finger back: XrForceFeedbackCurlApplyLocationMNDX::value, 0 for a free
 * finger, 1 for one that cannot curl at all.
 * @param curl of the finger now: 0 straight, 1 curled up. @param force N that pushes its tip back, against
 * curling; a finger that is pushed by `full_force` or more curls no further.
 * @return 0 without force, and for numbers that are not finite.
 * @since 0.1
 */
static inline float plp_openxr_curl(double curl, double force, double full_force) {
  const double held = force / full_force;
  if (!(held > 0 && curl >= 0)) return 0;
  return (float)((1 - fmin(1, curl)) * fmin(1, held));
}

#ifdef __cplusplus
}
#endif

#endif /* PALPATE_OPENXR_ADAPTOR_H */
