#include "StructureNames.h"

#include "../model/CaseModel.h"
#include "../model/Disclosure.h"
#include "../model/HapticControl.h"
#include "../model/LiveModel.h"
#include "../model/NeedleWords.h"

#include <insonate/image/Volume.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/Text.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate::train {
namespace {

constexpr double kCell_mm = 1;
constexpr int kSoonest_ms = 100;
/// A smaller cross-section has no name, in mm².
constexpr std::size_t kMinCells = 8;
/// Names that are nearer to each other would overlap.
constexpr double kApartLateral_mm = 11, kApartAxial_mm = 2;

/// The labels in the image plane, on a grid of cells.
struct PlaneLabels {
  int columns = 0, rows = 0;
  double left_mm = 0, top_mm = 0;
  std::vector<std::uint8_t> labels{};

  views::ImagePoint middleOf(int cell) const {
    return {left_mm + (cell % columns + 0.5) * kCell_mm, top_mm + (cell / columns + 0.5) * kCell_mm};
  }
};

/// Place of the tissue in the CT that the image shows at a point of its plane.
Vec3 atRest(const LiveFrame& frame, views::ImagePoint at) {
  const Vec3 place = frame.patientFromProbe * Vec3{at.lateral_mm, 0, at.axial_mm};
  const std::vector<Vec3>& middle = frame.press.middleAtRest_mm;
  if (middle.empty()) return place;
  const auto k = std::size_t(std::clamp(at.axial_mm / kMiddleStep_mm, 0.0, double(middle.size() - 1)));
  return place + (middle[k] - frame.patientFromProbe * Vec3{0, 0, double(k) * kMiddleStep_mm});
}

PlaneLabels labelsIn(const LiveFrame& frame, const LabelMap& map) {
  const BModeImage& image = frame.image;
  PlaneLabels plane{int(image.width * image.pixel_mm / kCell_mm), int(image.height * image.pixel_mm / kCell_mm),
                    image.left_mm, image.top_mm};
  const Transform indexFromPatient = map.geometry.indexFromPatient();
  const int count = plane.columns * plane.rows;
  plane.labels.reserve(std::size_t(count));
  for (int cell = 0; cell < count; ++cell)
    plane.labels.push_back(sampleNearest(map, indexFromPatient * atRest(frame, plane.middleOf(cell))));
  return plane;
}

/// Connected cells of one label; clears them in the plane.
std::vector<int> takeStructure(PlaneLabels& plane, int first) {
  const std::uint8_t label = std::exchange(plane.labels[std::size_t(first)], std::uint8_t{kBackground});
  std::vector<int> cells{first};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const int cell = cells[k], column = cell % plane.columns;
    const auto take = [&](bool isInside, int next) {
      if (!isInside || plane.labels[std::size_t(next)] != label) return;
      plane.labels[std::size_t(next)] = kBackground;
      cells.push_back(next);
    };
    take(column > 0, cell - 1);
    take(column + 1 < plane.columns, cell + 1);
    take(cell >= plane.columns, cell - plane.columns);
    take(cell + plane.columns < plane.columns * plane.rows, cell + plane.columns);
  }
  return cells;
}

/// The cell of a structure that is nearest to its centroid.
int middleCell(const PlaneLabels& plane, const std::vector<int>& cells) {
  double column = 0, row = 0;
  for (const int cell : cells) column += cell % plane.columns, row += cell / plane.columns;
  column /= double(cells.size()), row /= double(cells.size());
  return std::ranges::min(
      cells, {}, [&](int cell) { return std::hypot(cell % plane.columns - column, cell / plane.columns - row); });
}

bool isFilling(std::uint8_t label) {
  return label == kBackground || label == kSkin || label == kFat || label == kSoftTissue;
}

QString nameOf(std::uint8_t label) {
  const auto info = std::ranges::find(labelTable(), label, &LabelInfo::label);
  return info == labelTable().end() ? QString() : ui::qt(info->name);
}

}  // namespace

StructureNames::StructureNames(DisclosureModel& disclosure, HapticControl& hands, CaseModel& patientCase,
                               LiveModel& live, views::UltrasoundView& image, QObject* parent)
    : QObject(parent), disclosure_(disclosure), hands_(hands), case_(patientCase), live_(live), image_(image) {
  connect(&live_, &LiveModel::pictureShown, this, [this] {
    if (live_.isFrozen() || !sinceShown_.isValid() || sinceShown_.elapsed() >= kSoonest_ms) show();
  });
  connect(&disclosure_, &DisclosureModel::changed, this, [this] { show(); });
  connect(&case_, &CaseModel::caseChanged, this, [this] { show(); });
}

void StructureNames::setOn(bool isOn) {
  if (std::exchange(isOn_, isOn) == isOn) return;
  Q_EMIT switched(isOn);
  show();
}

void StructureNames::show() {
  sinceShown_.start();
  const bool isShown = isOn_ && disclosure_.current().anatomy && live_.shown() && case_.tissueLabels();
  image_.setNames(isShown ? names() : std::vector<views::NameOverlay>());
}

std::vector<views::NameOverlay> StructureNames::names() const {
  const LiveFrame& frame = *live_.shown();
  PlaneLabels plane = labelsIn(frame, *case_.tissueLabels());
  struct Structure {
    std::uint8_t label;
    std::vector<int> cells;
  };
  std::vector<Structure> structures;
  for (int cell = 0; cell < int(plane.labels.size()); ++cell) {
    const std::uint8_t label = plane.labels[std::size_t(cell)];
    if (isFilling(label)) continue;
    std::vector<int> cells = takeStructure(plane, cell);
    if (cells.size() >= kMinCells) structures.push_back({label, std::move(cells)});
  }
  // Vessels first, then by size: of names that would overlap, the first one stays.
  std::ranges::sort(structures, std::ranges::greater(), [](const Structure& one) {
    return std::pair(one.label == kVein || one.label == kArtery, one.cells.size());
  });
  std::vector<views::NameOverlay> all;
  for (const Structure& one : structures) {
    const views::ImagePoint at = plane.middleOf(middleCell(plane, one.cells));
    const bool isFree = std::ranges::none_of(all, [&](const views::NameOverlay& other) {
      return std::abs(other.at.lateral_mm - at.lateral_mm) < kApartLateral_mm &&
             std::abs(other.at.axial_mm - at.axial_mm) < kApartAxial_mm;
    });
    if (!isFree) continue;
    const QString vessel = vesselAt(hands_.session(), Label(one.label), atRest(frame, at));
    all.push_back({at, (vessel.isEmpty() ? nameOf(one.label) : vessel).toStdString()});
  }
  return all;
}

}  // namespace insonate::train
