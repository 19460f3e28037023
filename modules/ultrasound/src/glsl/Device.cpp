#include "glsl/Device.h"

#include "color/ColorPlan.h"
#include "color/FlowSegments.h"
#include "glsl/FrameBlock.h"
#include "model/Boundary.h"
#include "model/FramePlan.h"
#include "model/Impulse.h"
#include "model/NeedleEchoes.h"
#include "model/Reverberation.h"
#include "model/Scatterers.h"
#include "scene/BoundaryProfiles.h"
#include "scene/TextureTiles.h"
#include "thesis/ThesisModel.h"

#include <insonate/embedded/shaders.h>

#include <cmath>
#include <mutex>
#include <sstream>

namespace insonate::glsl {
namespace {

constexpr std::array<std::string_view, std::size_t(Stage::kCount)> kStageFiles{
    "contact",       "nodes",     "cells",        "tissue",      "crossings",    "levels",        "reaching",
    "aperture",      "penumbra",  "echoes",       "gas",         "reverberate",  "points",        "needle_shadow",
    "needle_echoes", "axial",     "lateral",      "envelope",    "thesis_map",   "thesis_echoes", "thesis_tail",
    "color_rest",    "color_way", "color_echoes", "color_axial", "color_lateral"};

const TextureTile& tileOf(int index) {
  return index < kTextureKinds ? textureTile(static_cast<Texture>(index)) : patchTile();
}

std::vector<std::int8_t> allTiles() {
  std::vector<std::int8_t> bytes;
  for (int t = 0; t < kTiles; ++t) {
    const TextureTile& tile = tileOf(t);
    bytes.insert(bytes.end(), tile.value.begin(), tile.value.end());
  }
  bytes.resize((bytes.size() + 3) / 4 * 4);
  return bytes;
}

}  // namespace

static_assert(kTiles == kTextureKinds + 1);

std::array<int, kTiles> tileOffsets() {
  std::array<int, kTiles> offsets{};
  for (int t = 1; t < kTiles; ++t) offsets[t] = offsets[t - 1] + static_cast<int>(tileOf(t - 1).value.size());
  return offsets;
}

std::string_view shaderFile(std::string_view name) {
  for (const auto& file : embedded::shaders::files())
    if (file.name == name) return file.text;
  return {};
}

std::string shaderText(std::string_view name, const EditedFile& edited) {
  constexpr std::string_view kInclude = "#include \"";
  std::istringstream lines(name == edited.name ? edited.text : std::string(shaderFile(name)));
  std::string text;
  for (std::string line; std::getline(lines, line); text += '\n') {
    const std::string_view view = line;
    text += view.starts_with(kInclude)
                ? shaderText(view.substr(kInclude.size(), view.find('.') - kInclude.size()), edited)
                : line;
  }
  return text;
}

/// Constants of the echoes behind gas.
template <class Real, class Whole>
void putGas(const Real& real, const Whole& whole) {
  whole("kFirstGateBehind", Reverberation::kFirstGate);
  real("kLungFromTrachea_mm", AcousticScene::kLungFromTrachea_mm);
  whole("kLungFiner", Reverberation::kLungFiner);
  real("kLungGain", Reverberation::kLungGain);
  real("kLungGrowth_perMm", Reverberation::kLungGrowth_perMm);
  real("kPatchVoxel_mm", patchTile().voxel_mm.x);
}

/// Constants of color Doppler.
template <class Real, class Whole>
void putColor(const Real& real, const Whole& whole) {
  whole("kContactColumns", ShownTissue::kColumns);
  whole("kKnotStep", ShownTissue::kKnotStep);
  whole("kColorFine", ColorPlan::kFine);
  whole("kMostSteps", kMostColorSteps);
  whole("kProfilePoints", BloodTube::kProfile);
  real("kTransmissionStep_mm", ColorPlan::kTransmissionStep_mm);
  real("kWallFilterPower", ColorPlan::kWallFilterPower);
  real("kBloodEdge_mm", kBloodEdge_mm);
  real("kLeastDepth_mm", kLeastDepth_mm);
  real("kReach_radii", FlowSegments::kReach_radii);
}

std::string constantsText() {
  std::ostringstream text;
  text.precision(9);
  text << std::showpoint;
  const auto real = [&](const char* name, double value) { text << "const float " << name << " = " << value << ";\n"; };
  const auto whole = [&](const char* name, int value) { text << "const int " << name << " = " << value << ";\n"; };
  const auto rays = [&](const char* name, const std::array<double, ApertureRays::kCount>& values) {
    text << "const float " << name << "[kRays] = float[kRays](" << values[0];
    for (std::size_t n = 1; n < values.size(); ++n) text << ", " << values[n];
    text << ");\n";
  };
  using namespace acoustics;
  whole("kRays", ApertureRays::kCount);
  rays("kRayTangent", ApertureRays::kTangent), rays("kRayWeight", ApertureRays::kWeight);
  real("kFaintest", ApertureRays::kFaintest);
  real("kUnseen", ApertureRays::kUnseen);
  real("kReflectorGain_dB", kReflectorGain_dB);
  real("kContactDepth_mm", kContactDepth_mm);
  real("kContactReach_mm", kContactReach_mm);
  real("kPoorContact_mm", kPoorContact_mm);
  real("kEdgeCosine", kEdgeCosine);
  real("kEdgeReach_mm", kEdgeReach_mm);
  real("kLayerPresence", kLayerPresence);
  real("kLayerPresencePerPatch", kLayerPresencePerPatch);
  real("kRoughnessBreaks", kRoughnessBreaks);
  real("kRoughnessLoss", kRoughnessLoss);
  real("kRoughnessDepth_mmPdB", kRoughnessDepth_mmPdB);
  real("kSheetCoherence", kSheetCoherence);
  real("kLayerWander_mm", kLayerWander_mm);
  whole("kWanderStep_voxels", kWanderStep_voxels);
  real("kTileRounding_voxels", TextureTile::kRounding_voxels);
  real("kUnitsPerMm", TissueField::kUnitsPerMm);
  real("kReach_mm", TissueField::kReach_mm);
  real("kProfileStep_mm", BoundaryProfiles::kStep_mm);
  whole("kProfileEntries", BoundaryProfiles::kEntries);
  real("kScattererUnit", kScattererUnit);
  real("kScattererMean", kScattererMean);
  real("kNarrowest_gates", Impulse::kNarrowest_gates);
  real("kWidest_gates", Impulse::kWidest_gates);
  putGas(real, whole), putColor(real, whole);
  whole("kNeedleRings", steel::kRings);
  real("kFirstNeedleRing", steel::kFirstRing);
  real("kNextNeedleRing", steel::kNextRing);
  real("kThesisReflectorGain_dB", thesis::kReflectorGain_dB);
  real("kBeyondLoss_dBpmm", thesis::kBeyondLoss_dBpmm);
  real("kSpeckleContrast", thesis::kSpeckleContrast);
  real("kNoiseSd", std::sqrt(thesis::noiseVariance()));
  whole("kNoiseOctaves", thesis::kNoiseOctaves);
  whole("kScattering", kScattering);
  whole("kReflection", kReflection);
  whole("kAttenuation", kAttenuation);
  whole("kTransmission", kTransmission);
  whole("kSpeckle", kSpeckle);
  whole("kLayers", kLayers);
  whole("kTexture", kTexture);
  whole("kEdgeShadow", kEdgeShadow);
  whole("kSheets", kSheets);
  whole("kGas", kGas);
  whole("kVessel", kVessel);
  return std::move(text).str();
}

Result<std::shared_ptr<const gpu::Program>> Device::compiled(const gpu::CurrentContext& current, std::string_view file,
                                                             const std::string& text) {
  const std::string constants = constantsText();
  auto program = gpu::Program::make(current, std::string(file), std::array<std::string_view, 2>{constants, text});
  if (!program) return tl::unexpected(program.error());
  if (auto same = program->checkBlock(current, "FrameBlock", frameFields(), sizeof(FrameBlock)); !same)
    return tl::unexpected(same.error());
  if (auto same = program->checkBlock(current, "ThesisBlock", thesisFields(), sizeof(ThesisBlock)); !same)
    return tl::unexpected(same.error());
  if (auto same = program->checkBlock(current, "ColorBlock", colorFields(), sizeof(ColorBlock)); !same)
    return tl::unexpected(same.error());
  return std::make_shared<const gpu::Program>(std::move(*program));
}

void Device::run(const gpu::CurrentContext& current, Stage stage, std::initializer_list<Binding> bindings, int groupsX,
                 int groupsY, int groupsZ) const {
  for (const Binding& b : bindings) b.buffer->bindStorage(current, b.slot);
  program(stage).run(current, groupsX, groupsY, groupsZ);
}

Result<void> Device::fill(const gpu::CurrentContext& current) {
  for (const std::string_view file : kStageFiles) {
    auto program = compiled(current, file, shaderText(file));
    if (!program) return tl::unexpected(program.error());
    programs_.push_back(std::move(*program));
  }
  const std::vector<std::int8_t> bytes = allTiles();
  auto tiles = gpu::Buffer::of(current, std::span<const std::int8_t>(bytes));
  if (!tiles) return tl::unexpected(tiles.error());
  tiles_ = std::make_shared<const gpu::Buffer>(std::move(*tiles));
  return current.check();
}

Result<std::shared_ptr<const Device>> Device::with(const EditedFile& edited) const {
  const auto current = context_->use();
  if (!current) return tl::unexpected(current.error());
  const std::shared_ptr<Device> device(new Device(*this));
  for (std::size_t stage = 0; stage < kStageFiles.size(); ++stage) {
    const std::string text = shaderText(kStageFiles[stage], edited);
    if (text == shaderText(kStageFiles[stage])) continue;
    auto program = compiled(*current, kStageFiles[stage], text);
    if (!program) return tl::unexpected(program.error());
    device->programs_[stage] = std::move(*program);
  }
  return device;
}

Result<std::shared_ptr<const Device>> Device::make() {
  auto context = gpu::Context::make();
  if (!context) return tl::unexpected(context.error());
  const std::shared_ptr<Device> device(new Device(*context));
  const auto current = device->context_->use();
  if (!current) return tl::unexpected(current.error());
  if (auto ok = device->fill(*current); !ok) return tl::unexpected(ok.error());
  return device;
}

Result<std::shared_ptr<const Device>> Device::shared() {
  // Never destroyed, since drivers are unloaded before the last objects of a process.
  static std::mutex mutex;
  static auto* device = new std::shared_ptr<const Device>;
  const std::scoped_lock lock(mutex);
  if (*device && !(*device)->context_->lost()) return *device;
  auto made = make();
  if (made) *device = *made;
  return made;
}

}  // namespace insonate::glsl
