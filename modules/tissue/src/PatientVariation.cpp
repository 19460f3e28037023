#include <insonate/core/Hash.h>
#include <insonate/tissue/PatientVariation.h>

#include <algorithm>

namespace insonate {
namespace {

/// Deviations of one patient, of unit SD and at most two SD, one after another: sums of three uniform numbers.
class Deviations {
 public:
  explicit Deviations(std::uint32_t seed) : seed_(seed) {}
  double next() {
    double sum = 0;
    for (int n = 0; n < 3; ++n) sum += unitInterval(hashNode(count_++, 0, 0, seed_)) - 0.5;
    return std::clamp(2 * sum, -2.0, 2.0);
  }

 private:
  std::uint32_t seed_;
  std::int32_t count_ = 0;
};

bool isMuscleOrFat(int label) {
  return label == kMuscle || label == kSternocleidomastoid || label == kFat;
}

void vary(BoundaryLayer& layer, Deviations& patient) {
  layer.echo_dB += 2 * patient.next();
  const double middle_mm = (layer.from_mm + layer.to_mm) / 2;
  const double half_mm = (layer.to_mm - layer.from_mm) / 2 * (1 + 0.2 * patient.next());
  layer.from_mm = middle_mm - half_mm, layer.to_mm = middle_mm + half_mm;
  const double patchiness = 0.12 * patient.next();
  if (layer.patchiness > 0) layer.patchiness = std::clamp(layer.patchiness + patchiness, 0.0, 1.0);
}

}  // namespace

AcousticTable tableOfPatient(const AcousticTable& table, std::uint32_t seed) {
  AcousticTable varied = table;
  Deviations patient(seed);
  for (int label = 0; label < kLabelCount; ++label) {
    AcousticTissue& tissue = varied.tissues[label];
    const double echo_dB = (isMuscleOrFat(label) ? 2.5 : 1.5) * patient.next();
    if (!tissue.gas && !tissue.vessel) tissue.echogenicity_dB += echo_dB;
    tissue.textureStrength_dB *= 1 + 0.15 * patient.next();
    tissue.roughness_dB *= 1 + 0.2 * patient.next();
    for (BoundaryLayer& layer : tissue.layers) vary(layer, patient);
  }
  return varied;
}

}  // namespace insonate
