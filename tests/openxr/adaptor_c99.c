/* That it compiles is the test. */
#include <palpate/openxr_adaptor.h>

plp_openxr_vibration vibrate(plp_openxr_touch* touch, const plp_contacts* contacts, double now);

plp_openxr_vibration vibrate(plp_openxr_touch* touch, const plp_contacts* contacts, double now) {
  const plp_openxr_vibration_options options = plp_openxr_vibration_defaults();
  return plp_openxr_vibrate(&options, touch, contacts, now);
}
