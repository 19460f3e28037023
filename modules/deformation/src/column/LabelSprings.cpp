#include "LabelSprings.h"

#include <algorithm>
#include <numeric>

namespace insonate::column {
namespace {

double complianceOf(const MechanicalTissue& tissue, int label) {
  switch (tissue.kind) {
    case Mechanics::Solid:
      return tissue.young_kPa > 0 ? 1 / tissue.young_kPa : 0;
    case Mechanics::Lumen:
      return 1 / (label == kArtery ? kArteryLumen_kPa : kVeinLumen_kPa);
    case Mechanics::Rigid:
    // The tissue around air holds it open; a spring without stiffness would take the whole compression.
    case Mechanics::Gas:
      break;
  }
  return 0;
}

}  // namespace

LabelSprings::LabelSprings(const MechanicalTable& tissues) {
  for (int label = 0; label < kLabelCount; ++label)
    compliance_perkPa[label] = complianceOf(tissues.tissues[label], label);
  std::iota(softestFirst.begin(), softestFirst.end(), 0);
  std::stable_sort(softestFirst.begin(), softestFirst.end(),
                   [this](int a, int b) { return compliance_perkPa[a] > compliance_perkPa[b]; });
}

ColumnLoad LabelSprings::loadAtShortening(double shortening_mm, const LengthByLabel& length_mm) const {
  ColumnLoad load;
  if (!(shortening_mm > 0)) return load;
  // The softest springs reach their limit first; the others take the rest.
  double atLimit_mm = 0;
  for (int next = 0; next < kLabelCount; ++next) {
    double compliance_mmPerkPa = 0;
    for (int i = next; i < kLabelCount; ++i)
      compliance_mmPerkPa += length_mm[softestFirst[i]] * compliance_perkPa[softestFirst[i]];
    if (!(compliance_mmPerkPa > 0)) break;
    load.pressure_kPa = (shortening_mm - atLimit_mm) / compliance_mmPerkPa;
    const int softest = softestFirst[next];
    if (load.pressure_kPa * compliance_perkPa[softest] <= kMaxShortening) {
      load.shortening_mm = shortening_mm;
      return load;
    }
    load.pressure_kPa = kMaxShortening / compliance_perkPa[softest];
    atLimit_mm += kMaxShortening * length_mm[softest];
  }
  load.shortening_mm = atLimit_mm;
  load.limited = true;
  return load;
}

double LabelSprings::limit_mm(const LengthByLabel& length_mm) const {
  double limit_mm = 0;
  for (int label = 0; label < kLabelCount; ++label)
    if (compliance_perkPa[label] > 0) limit_mm += kMaxShortening * length_mm[label];
  return limit_mm;
}

double LabelSprings::strain(std::uint8_t label, double pressure_kPa) const {
  return std::min(pressure_kPa * compliance_perkPa[knownLabel(label)], kMaxShortening);
}

}  // namespace insonate::column
