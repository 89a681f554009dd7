/* The adaptor's structs beside those of OpenXR's own header, used as a host would use both. */
#include <openxr/openxr.h>
#include <palpate/openxr_adaptor.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void expect(int condition, const char* what) {
  if (condition) return;
  fprintf(stderr, "OpenXR: failed: %s\n", what);
  exit(1);
}

static void poses_are_copied(void) {
  const XrPosef located = {{0.5f, -0.5f, 0.5f, 0.5f}, {1, 2, 3}};
  plp_openxr_pose given;
  expect(sizeof given == sizeof located, "the size of a pose");
  memcpy(&given, &located, sizeof given);
  plp_pose pose;
  expect(plp_openxr_pose_in(&given, &pose), "a pose is usable");
  expect(pose.orientation[1] == -0.5 && pose.orientation[3] == 0.5, "orientation");
  expect(pose.position[0] == 1 && pose.position[2] == 3, "position");
  const plp_openxr_pose drawn = plp_openxr_pose_out(&pose);
  expect(memcmp(&drawn, &located, sizeof drawn) == 0, "a pose comes back");
}

static void vibrations_are_taken_over(void) {
  plp_openxr_vibration_options options = plp_openxr_vibration_defaults();
  options.frequency = XR_FREQUENCY_UNSPECIFIED;
  plp_openxr_touch touch = {0, 0, 0};
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  contacts.set_count = 1;
  contacts.wrench.force[1] = 0.5 * options.full_force;
  const plp_openxr_vibration begun = plp_openxr_vibrate(&options, &touch, &contacts, 10.0);
  const XrHapticVibration tick = {XR_TYPE_HAPTIC_VIBRATION, NULL, begun.duration, begun.frequency,
                                  begun.amplitude};
  expect(tick.duration == 12000000 && tick.duration > 0, "XrDuration is nanoseconds");
  expect(tick.amplitude == 0.8f && tick.frequency == 200.0f, "the tick");
  const plp_openxr_vibration held = plp_openxr_vibrate(&options, &touch, &contacts, 10.1);
  expect(held.frequency == XR_FREQUENCY_UNSPECIFIED && held.amplitude == 0.5f, "the contact");
}

int main(void) {
  poses_are_copied();
  vibrations_are_taken_over();
  printf("OpenXR %d.%d: 2 passed, 0 failed\n", (int)XR_VERSION_MAJOR(XR_CURRENT_API_VERSION),
         (int)XR_VERSION_MINOR(XR_CURRENT_API_VERSION));
  return 0;
}
