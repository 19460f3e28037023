#include "Variants.h"
#include "neck/NeckRegion.h"

#include <insonate/cases/Phantom.h>
#include <insonate/cases/TissueLabels.h>

#include <algorithm>
#include <array>

namespace insonate {
namespace {

using namespace phantom;

std::string_view nameOf(PhantomRegion region) {
  switch (region) {
    case PhantomRegion::kArm:
      return "upper arm";
    case PhantomRegion::kGroin:
      return "groin";
    case PhantomRegion::kNeck:
    case PhantomRegion::kChest:
      return "neck";
  }
  return "";
}

Result<const VariantModel*> modelOf(std::string_view variant) {
  const auto models = variantModels();
  const auto model = std::find_if(models.begin(), models.end(), [&](const auto& v) { return v.about.name == variant; });
  if (model != models.end()) return &*model;
  std::string known;
  for (const VariantModel& v : models) known += (known.empty() ? "" : ", ") + std::string(v.about.name);
  return fail("There is no built-in case called '" + std::string(variant) + "'. Choose one of: " + known + ".");
}

Region regionOf(const VariantModel& model, std::uint32_t seed) {
  return std::visit([&](const auto& parameters) { return makeRegion(parameters, seed); }, model.parameters);
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
  const auto found = modelOf(variant);
  if (!found) return tl::unexpected(found.error());
  const VariantModel* model = *found;

  Region region = regionOf(*model, seed);
  auto labels = region.model.rasterise(region.grid, partOf(progress, 0, 0.6));
  if (!labels) return tl::unexpected(labels.error());
  const auto tissues = withTissueLabels(region.ownLabels, *labels);
  auto ct = synthesizeCt(tissues ? *tissues : *labels, {.seed = seed, .contrast = contrast}, partOf(progress, 0.6, 1));
  if (!ct) return tl::unexpected(ct.error());

  PatientCase patient;
  patient.manifest.title = model->about.title;
  patient.manifest.description = model->about.description;
  patient.manifest.difficulty = model->about.difficulty;
  patient.manifest.source = "Built-in parametric " + std::string(nameOf(model->about.region)) + ", variant " +
                            std::string(variant) + ", seed " + std::to_string(seed) +
                            (contrast == CtContrast::kArterial ? ", contrast" : "");
  patient.manifest.targets = std::move(region.targets);
  patient.manifest.vessels = region.model.namedVessels();
  patient.manifest.startPoses = std::move(region.startPoses);
  patient.manifest.landmarks = std::move(region.landmarks);
  for (int label = kSkin; label < kLabelCount; ++label)
    patient.manifest.states[static_cast<std::uint8_t>(label)] = LabelState::Completed;
  for (const auto& own : region.ownLabels) patient.manifest.states[own.first] = LabelState::Completed;
  patient.manifest.ownLabels = std::move(region.ownLabels);
  patient.ct = std::move(*ct);
  patient.labels = std::move(*labels);
  return patient;
}

Result<PhantomLabels> phantomLabels(std::string_view variant, std::uint32_t seed, const VolumeGeometry& grid,
                                    const Progress& progress) {
  const auto model = modelOf(variant);
  if (!model) return tl::unexpected(model.error());
  if (auto valid = validate(grid); !valid) return tl::unexpected(valid.error());
  if (!(grid.direction == Mat3()))
    return fail("The axes of the grid of a built-in case must be the patient's axes, but this grid is rotated.");
  const Region region = regionOf(**model, seed);
  auto labels = region.model.rasterise(grid, progress);
  if (!labels) return tl::unexpected(labels.error());
  if (auto tissues = withTissueLabels(region.ownLabels, *labels)) labels = std::move(*tissues);
  return PhantomLabels{std::move(*labels), region.model.namedVessels()};
}

}  // namespace insonate
