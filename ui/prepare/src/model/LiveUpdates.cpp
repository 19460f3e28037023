#include "LiveUpdates.h"

#include "../labels/LabelSession.h"
#include "LivePatient.h"
#include "OpenCase.h"
#include "StructureAppearance.h"
#include "TermsEditor.h"

#include <insonate/tissue/Labels.h>

#include <utility>

namespace insonate::prepare {
namespace {

/// Number of triangles with which 3D turns without a graphics card: fine for small structures, coarse for large ones.
SurfaceOptions surfaceOptions(std::uint8_t label) {
  switch (label) {
    case kSkin:
      return {8, 3};
    case kFat:
    case kSoftTissue:
      return {6, 3};
    case kBone:
    case kAirway:
    case kMuscle:
    case kSternocleidomastoid:
      return {5, 2};
    case kThyroid:
    case kGland:
    case kOesophagus:
    case kCartilage:
      return {5, 1.5};
    default:
      return {4, 1};
  }
}

/// Structures in the order in which authors look for them.
constexpr std::uint8_t kOrder[] = {kVein, kArtery, kSkin, kBone, kAirway, kThyroid, kCartilage, kSternocleidomastoid};

}  // namespace

LiveUpdates::LiveUpdates(OpenCase& openCase, const StructureAppearance& appearance, const TermsEditor& terms,
                         LabelSession& labeling, LivePatient& live, QObject* parent)
    : QObject(parent), appearance_(appearance) {
  connect(&openCase, &OpenCase::closing, &live, &LivePatient::stop);
  connect(&openCase, &OpenCase::opened, this, [this] { wanted_ = {}; });
  connect(&openCase, &OpenCase::shown, this, [this, &openCase, &terms, &live] {
    live.setPatient(openCase.patient(), missingSurfaces());
    live.setOwnLabels(terms.value().own);
  });
  connect(&openCase, &OpenCase::saved, this, [&openCase, &live] { live.replacePatient(openCase.patient()); });
  connect(&terms, &TermsEditor::ownLabelsEdited, this, [&terms, &live] { live.setOwnLabels(terms.value().own); });
  connect(&appearance, &StructureAppearance::lookChanged, this, [this, &labeling, &live] {
    for (ui::SurfaceRequest& wish : missingSurfaces()) {
      wish.labels = labeling.snapshot();
      live.wantSurface(wish);
    }
  });
}

std::vector<ui::SurfaceRequest> LiveUpdates::missingSurfaces() {
  std::vector<ui::SurfaceRequest> wishes;
  const auto wish = [&](std::uint8_t label) {
    const StructureLook& look = appearance_.look(label);
    if (!look.visible || look.opacity <= 0 || std::exchange(wanted_[label], true)) return;
    wishes.push_back({label, surfaceOptions(label)});
  };
  for (const std::uint8_t label : kOrder) wish(label);
  for (int label = 1; label < 256; ++label) wish(std::uint8_t(label));
  return wishes;
}

std::vector<ui::SurfaceRequest> LiveUpdates::changedSurfaces(const LabelSet& labels) const {
  std::vector<ui::SurfaceRequest> wishes;
  for (int label = 1; label < 256; ++label) {
    const auto value = std::uint8_t(label);
    // The surface of the skin is that of the body: it changes when the outside does.
    const bool moved = labels.test(value) || (value == kSkin && labels.test(kBackground));
    if (moved && appearance_.look(value).opacity > 0) wishes.push_back({value, surfaceOptions(value)});
  }
  return wishes;
}

}  // namespace insonate::prepare
