#pragma once

#include "LoopRig.h"

namespace insonate::haptics {

/// Labels that fill the layer under the skin: all but the outside, whose inside nobody is in.
inline std::vector<Label> fillings() {
  std::vector<Label> all;
  for (int label = 1; label < kLabelCount; ++label) all.push_back(static_cast<Label>(label));
  return all;
}

struct Least {
  double probe_J = 0, needle_J = 0, both_J = 0;
  std::size_t events = 0;
};

/// Least energy that a hand had put into device and loop at any moment of a contact. Apart, the tools never meet.
inline Least minEnergy(const DeviceProfile& profile, Label filling, const char* table, int ticks, unsigned seed,
                       bool apart) {
  LoopRig rig(profile.limits, layerOf(filling), {-90, 0, -30}, {0, 0, -30}, {}, table);
  RandomHand probe(seed, {apart ? -90.0 : -30.0, -5, -15}, {apart ? -50.0 : 0.0, 5, 12});
  RandomHand needle(seed + 1000, {-12, -4, -12}, {12, 4, 40});
  probe.at_mm = {-90, 0, -30};
  PassivityObserver both;
  for (int i = 0; i < ticks; ++i) {
    const ServoOutput out = rig.tick(probe.next(), needle.next());
    const double sum_J =
        rig.hands[0].intoLoop_J() + rig.hands[0].lost_J() + rig.hands[1].intoLoop_J() + rig.hands[1].lost_J();
    both.add(sum_J, norm(out.tools[0].force.force_N) + norm(out.tools[1].force.force_N) > 0);
  }
  return {rig.observers[0].minEnergy_J(), rig.observers[1].minEnergy_J(), both.minEnergy_J(), rig.events.size()};
}

inline void expectPassive(const DeviceProfile& profile, int ticks) {
  unsigned seed = 1;
  for (const char* table : {"measured", "thesis"})
    for (const Label filling : fillings()) {
      const Least least = minEnergy(profile, filling, table, ticks, seed++, true);
      EXPECT_GE(least.probe_J, 0) << profile.name << ", " << labelTable()[filling].name << ", " << table;
      EXPECT_GE(least.needle_J, 0) << profile.name << ", " << labelTable()[filling].name << ", " << table;
    }
}

}  // namespace insonate::haptics
