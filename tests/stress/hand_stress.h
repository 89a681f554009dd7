#pragma once

#include <functional>
#include <span>

namespace palpate::stress {

// Two models of the catalogue, the tool in a simulated hand that moves by a script.
struct HandScene {
  const char* name;
  const char* body;
  const char* tool;
};

std::span<const HandScene> hand_scenes();

// What a passivity observer and a microphone would note.
struct HandOutcome {
  double seconds = 0.0;     // simulated
  int cycles = 0;           // of the scripts
  int active = 0;           // cycles that gave the hand more energy than half a count of the encoder holds
  double most_given = 0.0;  // J in one cycle of a tap or slide; negative: every cycle took some
  double pushed = 0.0;      // N, the largest force
  double buzz = 0.0;        // N, root mean square from 100 to 500 Hz while the hand rests on the surface
  double deviation = 0.0;   // N, of the force meanwhile
  int loud = 0;             // rests whose buzz is more than the step of one count
  int disarmed = 0;         // runs that the safety limits ended
  int idle = 0;             // runs in which nothing pushed

  int faults() const { return active + loud + disarmed + idle; }
};

// Presses, taps and slides, on either device and under the device's cap and none, until `enough` says so;
// every script runs at least a few cycles.
HandOutcome stress_hand(const HandScene& scene, const std::function<bool()>& enough);

}  // namespace palpate::stress
