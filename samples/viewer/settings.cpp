#include "samples/viewer/settings.h"

namespace palpate::viewer {

Settings changed(Settings settings, const Settings& before, const Settings& now) {
  const auto take = [&](auto Settings::*field) {
    if (before.*field != now.*field) settings.*field = now.*field;
  };
  take(&Settings::cutoff);
  take(&Settings::stiffness);
  take(&Settings::damping);
  take(&Settings::stiffness_cap);
  take(&Settings::friction);
  take(&Settings::mode);
  take(&Settings::law);
  return settings;
}

}  // namespace palpate::viewer
