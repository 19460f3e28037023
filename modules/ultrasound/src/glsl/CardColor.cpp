#include "glsl/CardColor.h"

#include "glsl/Tables.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::glsl {
namespace {

// Slots of the buffers; the stages share 0 to 3.
constexpr unsigned kVolumes = 0, kPlan = 2, kContacts = 3, kFlow = 4, kRests = 5, kPassed = 6, kEchoes = 7;
constexpr int kThreads = 64;    ///< of a group
constexpr int kComponents = 3;  ///< power, real and imaginary part at a lag of one pulse
constexpr int kProfileWords = (BloodTube::kProfile + 3) / 4;
constexpr int kUsualFlowWords = 4096;  ///< of some hundred segments; more take more memory when they come

float single(double value) {
  return static_cast<float>(value);
}

int groupsOf(int threads) {
  return (threads + kThreads - 1) / kThreads;
}

/// Knots between which `count` points of a scanline lie.
int knotsOf(int count) {
  return (count + ShownTissue::kKnotStep - 1) / ShownTissue::kKnotStep + 1;
}

int channelOf(const TissueField& field, std::uint8_t label) {
  for (int c = 0; c < field.channels; ++c)
    if (field.label[c] == label) return c;
  return -1;
}

}  // namespace

CardColor::CardColor(std::shared_ptr<const Device> device, const Probe& probe, const ImagingSettings& settings,
                     const ColorSettings& color)
    : device_(std::move(device)), plan_(probe, settings, color) {
  frameBlock_.nodeColumns = ShownTissue::kColumns, frameBlock_.cellLines = 1;
  frameBlock_.conforming = settings.conformingContact ? 1 : 0;
  ColorBlock& b = colorBlock_;
  b.fineLines = plan_.fineLines, b.fineGates = plan_.fineGates, b.lines = plan_.lines, b.gates = plan_.gates;
  b.lateralMargin = plan_.lateralMargin, b.axialMargin = plan_.axialMargin;
  b.gateKnots = knotsOf(plan_.fineGates), b.wayKnots = knotsOf(plan_.transmissionSteps);
  b.lineTable = ShownTissue::kColumns, b.knotTable = b.lineTable + plan_.fineLines;
  b.steps = plan_.transmissionSteps;
  b.firstRange_mm = single(plan_.range_mm(0)), b.fineGate_mm = single(plan_.gate_mm / ColorPlan::kFine);
  b.turnsPerVelocity = single(0.5 / plan_.nyquist_mmps);
  b.perCutoff = color.wallFilter_Hz > 0 ? single(color.prf_Hz / color.wallFilter_Hz) : 0;
  for (int p = 0; p < ColorPlan::kPlanes; ++p)
    b.plane[p] = {single(plan_.elevation_mm[p]), single(plan_.planeWeight[p]), 0, 0};
}

Result<std::unique_ptr<CardColor>> CardColor::make(std::shared_ptr<const Device> device, const Probe& probe,
                                                   const ImagingSettings& settings, const ColorSettings& color) {
  const auto current = device->context().use();
  if (!current) return tl::unexpected(current.error());
  std::unique_ptr<CardColor> card(new CardColor(std::move(device), probe, settings, color));
  if (auto ok = card->allocate(*current); !ok) return tl::unexpected(ok.error());
  return card;
}

/// Columns of contacts, as scanlines of the image; scanlines of color, with their place among the columns; then the
/// displayed points at the knots of each scanline (see shaders/color_rest.comp).
std::vector<Float4> CardColor::planTable() const {
  std::vector<Float4> table;
  for (int column = 0; column < ShownTissue::kColumns; ++column) {
    const double scanline = ShownTissue::scanlineOf(plan_, column);
    const Vec3 origin = plan_.image.origin(scanline), direction = plan_.image.direction(scanline);
    table.push_back({single(origin.x), single(origin.z), single(direction.x), single(direction.z)});
  }
  for (int line = 0; line < plan_.fineLines; ++line) {
    const double beam = plan_.beam(line);
    const Vec3 direction = plan_.beams.direction(beam), face = plan_.point_mm(beam, 0);
    const double column = ShownTissue::columnOf(plan_, plan_.image.locate(face.x, face.z).scanline);
    table.push_back({single(direction.x), single(direction.z), single(column), 0});
  }
  for (int line = 0; line < plan_.fineLines; ++line) {
    for (int knot = 0; knot < colorBlock_.gateKnots; ++knot)
      addKnot(line, plan_.range_mm(knot * ShownTissue::kKnotStep), table);
    for (int knot = 0; knot < colorBlock_.wayKnots; ++knot)
      addKnot(line, ColorPlan::transmissionRange_mm(knot * ShownTissue::kKnotStep), table);
  }
  return table;
}

/// Adds position and direction of the image's scanline at a displayed point; its range along this scanline, and its
/// place among the columns.
void CardColor::addKnot(int line, double range_mm, std::vector<Float4>& table) const {
  const Vec3 shown = plan_.point_mm(plan_.beam(line), std::max(range_mm, 0.0));
  const BeamGrid::Location at = plan_.image.locate(shown.x, shown.z);
  const Vec3 direction = plan_.image.direction(at.scanline);
  table.push_back({single(shown.x), single(shown.z), single(direction.x), single(direction.z)});
  table.push_back({single(plan_.image.range_mm(at.sample)), single(ShownTissue::columnOf(plan_, at.scanline)), 0, 0});
}

Result<void> CardColor::allocate(const gpu::CurrentContext& current) {
  if (plan_.transmissionSteps > kMostColorSteps) return fail("The color box is too deep for the graphics card.");
  Result<void> ok;
  const auto keep = [&](Result<gpu::Buffer> made, gpu::Buffer& buffer) {
    if (!made)
      ok = tl::unexpected(made.error());
    else
      buffer = std::move(*made);
  };
  const auto room = [&](std::size_t bytes, gpu::Buffer& buffer) {
    if (ok) keep(gpu::Buffer::make(current, bytes), buffer);
  };
  const auto fill = [&](const auto& values, gpu::Buffer& buffer) {
    if (ok) keep(gpu::Buffer::of(current, std::span(values)), buffer);
  };
  const std::size_t fineLines = plan_.fineLines, lines = plan_.lines, gates = plan_.gates;
  const std::size_t lattice = fineLines * plan_.fineGates;
  std::vector<float> kernels(plan_.axialKernel.begin(), plan_.axialKernel.end());
  kernels.insert(kernels.end(), plan_.lateralKernel.begin(), plan_.lateralKernel.end());
  fill(planTable(), planTable_), fill(kernels, kernels_);
  room(sizeof(FrameBlock), frame_), room(sizeof(ColorBlock), color_);
  room(ShownTissue::kColumns * 2 * sizeof(float), contacts_);
  room(fineLines * (colorBlock_.gateKnots + colorBlock_.wayKnots) * 2 * sizeof(float), rests_);
  flowWords_.reserve(kUsualFlowWords);
  room(kUsualFlowWords * sizeof(Float4), flow_);
  room(lattice * sizeof(float), passed_), room(kComponents * lattice * sizeof(float), echoes_);
  room(kComponents * fineLines * gates * sizeof(float), axial_);
  room(kComponents * lines * gates * sizeof(float), averages_);
  if (!ok) return ok;
  auto readBack = gpu::ReadBack::make(current, lines * gates * sizeof(float));
  if (!readBack) return tl::unexpected(readBack.error());
  readBack_ = std::move(*readBack);
  return {};
}

void CardColor::setTissues(const AcousticScene::Impl& scene) {
  const TissueField& field = scene.field;
  for (int c = 0; c < field.channels; ++c) {
    const double level_dB = scene.table.of(field.label[c]).echogenicity_dB;
    colorBlock_.echoPower[c].x = single(std::pow(10, level_dB / 10) / plan_.noisePower);
    for (int before = 0; before < field.channels; ++before)
      colorBlock_.transmitted[before * TissueField::kStride + c] = single(
          transmittedPower(scene.table, plan_, field.label[before], field.label[c], ColorPlan::kTransmissionStep_mm));
  }
  colorBlock_.artery = channelOf(field, kArtery), colorBlock_.vein = channelOf(field, kVein);
}

Result<void> CardColor::uploadFlow(const gpu::CurrentContext& current, const BloodFlow* blood,
                                   const Transform& patientFromProbe, const TissueField& field) {
  colorBlock_.segments = 0;
  if (!blood || blood->empty()) return {};
  segments_.update(*blood, patientFromProbe, plan_.elevation_mm.back());
  flowWords_.clear();
  for (const FlowSegment& s : segments_.all()) {
    const auto words = [this](Vec3 v, double w) {
      flowWords_.push_back({single(v.x), single(v.y), single(v.z), single(w)});
    };
    words({s.x, s.y, s.z}, s.radius_mm), words({s.dx, s.dy, s.dz}, s.radiusChange);
    words(s.direction, s.scale), words(s.directionChange, s.scaleChange);
    words({s.perLength2, double(channelOf(field, s.label)), double(s.tube)}, 0);
  }
  colorBlock_.segments = static_cast<std::int32_t>(segments_.all().size());
  colorBlock_.profileTable = static_cast<std::int32_t>(flowWords_.size());
  for (const BloodTube& tube : blood->tubes) {
    std::array<float, 4 * kProfileWords> profile{};
    std::ranges::transform(tube.profile_mmps, profile.begin(), single);
    for (int w = 0; w < kProfileWords; ++w)
      flowWords_.push_back({profile[4 * w], profile[4 * w + 1], profile[4 * w + 2], profile[4 * w + 3]});
  }
  const std::span<const std::byte> words = std::as_bytes(std::span(flowWords_));
  if (words.size() > flow_.bytes()) {
    auto larger = gpu::Buffer::make(current, words.size());
    if (!larger) return tl::unexpected(larger.error());
    flow_ = std::move(*larger);
  }
  flow_.write(current, words);
  return {};
}

Result<void> CardColor::upload(const gpu::CurrentContext& current, const AcousticScene::Impl& scene,
                               const Transform& patientFromProbe, const PlaneDisplacement& displacement,
                               const ColorMotion& motion) {
  auto volumes = device_->scenes().of(current, scene);
  if (!volumes) return tl::unexpected(volumes.error());
  volumes_ = std::move(*volumes);
  setScene(scene, frameBlock_);
  frameBlock_.nodeFromProbe = rowsOf(scene.field.nodeFromPatient * patientFromProbe);
  if (auto ok = uploadDisplacement(current, displacement, frameBlock_, displacement_); !ok) return ok;
  setTissues(scene);
  const Vec3 v = motion.tissue_mmps;
  colorBlock_.tissue_mmps = {single(v.x), single(v.y), single(v.z), 0};
  if (auto ok = uploadFlow(current, motion.blood, patientFromProbe, scene.field); !ok) return ok;
  frame_.write(current, std::as_bytes(std::span(&frameBlock_, 1)));
  color_.write(current, std::as_bytes(std::span(&colorBlock_, 1)));
  return {};
}

void CardColor::bindShared(const gpu::CurrentContext& current) const {
  frame_.bindUniform(current, 0), color_.bindUniform(current, 1);
  displacement_.bind(current, 0);
  volumes_->bindStorage(current, kVolumes);
  planTable_.bindStorage(current, kPlan);
  contacts_.bindStorage(current, kContacts);
}

/// While one component is copied, the next is queued.
Result<void> CardColor::readFrame(const gpu::CurrentContext& current, ColorFrame& frame) {
  const std::size_t bytes = frame.power.size() * sizeof(float);
  std::vector<float>* const components[] = {&frame.power, &frame.lagOneRe, &frame.lagOneIm};
  int read = 0;
  const auto finish = [&] { return readBack_.finish(current, std::as_writable_bytes(std::span(*components[read++]))); };
  for (int component = 0; component < kComponents; ++component) {
    if (readBack_.full())
      if (auto ok = finish(); !ok) return ok;
    readBack_.begin(current, averages_, component * bytes, bytes);
  }
  while (read < kComponents)
    if (auto ok = finish(); !ok) return ok;
  return {};
}

Result<void> CardColor::render(const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                               const PlaneDisplacement& displacement, const ColorMotion& motion, ColorFrame& frame) {
  const auto current = device_->context().use();
  if (!current) return tl::unexpected(current.error());
  if (auto ok = upload(*current, scene, patientFromProbe, displacement, motion); !ok) return ok;
  bindShared(*current);
  const int knots = colorBlock_.gateKnots + colorBlock_.wayKnots;
  device_->run(*current, Stage::Contact, {}, 2);  // 32 columns each
  device_->run(*current, Stage::ColorRest, {{kRests, &rests_}}, groupsOf(knots * plan_.fineLines));
  device_->run(*current, Stage::ColorWay, {{kRests, &rests_}, {kPassed, &passed_}}, plan_.fineLines);
  device_->run(*current, Stage::ColorEchoes,
               {{kFlow, &flow_}, {kRests, &rests_}, {kPassed, &passed_}, {kEchoes, &echoes_}},
               groupsOf(plan_.fineGates), plan_.fineLines);
  // The slots of shaders/kernels.glsl.
  device_->run(*current, Stage::ColorAxial, {{5, &kernels_}, {6, &echoes_}, {7, &axial_}}, groupsOf(plan_.gates),
               plan_.fineLines, kComponents);
  device_->run(*current, Stage::ColorLateral, {{5, &kernels_}, {6, &axial_}, {7, &averages_}}, groupsOf(plan_.gates),
               plan_.lines, kComponents);
  frame.resize(plan_.lines, plan_.gates);
  return readFrame(*current, frame);
}

}  // namespace insonate::glsl
