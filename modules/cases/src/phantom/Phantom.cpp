#include "NeckModel.h"
#include "Poses.h"
#include "Variants.h"

#include <insonate/cases/Phantom.h>

#include <algorithm>
#include <array>

namespace insonate {
namespace {

using namespace phantom;

/// The neck, or the region below the right clavicle.
VolumeGeometry phantomGrid(bool chest) {
  VolumeGeometry g;
  g.size = {304, 284, 148};
  g.spacing_mm = {0.5, 0.5, 0.75};
  g.origin_mm = chest ? Vec3{-124.75, -36, -97.5} : Vec3{-75.75, -36, -61.5};
  return g;
}

/// A progress that covers only a part of the bar.
Progress partOf(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [&progress, from, to](std::string_view doing, double t) { return progress(doing, from + (to - from) * t); };
}

}  // namespace

std::span<const PhantomVariant> phantomVariants() {
  static const std::vector<PhantomVariant> kAbout = [] {
    std::vector<PhantomVariant> about;
    for (const VariantModel& v : variantModels()) about.push_back(v.about);
    return about;
  }();
  return kAbout;
}

const PhantomVariant* phantomVariant(std::string_view nameOrTitle) {
  const auto all = phantomVariants();
  const auto found = std::ranges::find_if(
      all, [&](const PhantomVariant& one) { return nameOrTitle == one.name || nameOrTitle == one.title; });
  return found == all.end() ? nullptr : &*found;
}

Result<PatientCase> makePhantom(std::string_view variant, std::uint32_t seed, const Progress& progress,
                                CtContrast contrast) {
  const auto models = variantModels();
  const auto model = std::find_if(models.begin(), models.end(), [&](const auto& v) { return v.about.name == variant; });
  if (model == models.end()) {
    std::string known;
    for (const VariantModel& v : models) known += (known.empty() ? "" : ", ") + std::string(v.about.name);
    return fail("There is no built-in neck called '" + std::string(variant) + "'. Choose one of: " + known + ".");
  }

  const NeckModel neck(model->parameters, seed);
  auto labels = neck.rasterise(phantomGrid(model->parameters.chest), partOf(progress, 0, 0.6));
  if (!labels) return tl::unexpected(labels.error());
  auto ct = synthesizeCt(*labels, {.seed = seed, .contrast = contrast}, partOf(progress, 0.6, 1));
  if (!ct) return tl::unexpected(ct.error());

  PatientCase patient;
  patient.manifest.title = model->about.title;
  patient.manifest.description = model->about.description;
  patient.manifest.difficulty = model->about.difficulty;
  patient.manifest.source = "Built-in parametric neck, variant " + std::string(variant) + ", seed " +
                            std::to_string(seed) + (contrast == CtContrast::kArterial ? ", contrast" : "");
  const bool chest = model->parameters.chest;
  patient.manifest.targets = chest ? axillaryTargets(neck) : jugularTargets(neck);
  patient.manifest.vessels = neck.namedVessels();
  patient.manifest.startPoses = chest ? axillaryStartPoses(neck) : jugularStartPoses(neck);
  patient.manifest.landmarks = landmarks(neck, patient.manifest.startPoses);
  for (int label = kSkin; label < kLabelCount; ++label)
    patient.manifest.states[static_cast<std::uint8_t>(label)] = LabelState::Completed;
  patient.ct = std::move(*ct);
  patient.labels = std::move(*labels);
  return patient;
}

}  // namespace insonate
