#include "glsl/CardFrame.h"

#include "scene/TextureTiles.h"

#include <algorithm>
#include <chrono>

namespace insonate::glsl {
namespace {

// Slots of buffers that most stages read.
constexpr unsigned kSceneSlot = 0, kTilesSlot = 1, kPlanSlot = 2, kContactsSlot = 3, kShiftsSlot = 4;

using Clock = std::chrono::steady_clock;

double msSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

template <class T>
std::span<const std::byte> bytesOf(const T& values) {
  return std::as_bytes(std::span(values));
}

template <class T>
std::span<const std::byte> bytesOfOne(const T& value) {
  return std::as_bytes(std::span(&value, 1));
}

}  // namespace

CardFrame::CardFrame(std::shared_ptr<const Device> device, const Probe& probe, const ImagingSettings& settings)
    : device_(std::move(device)),
      plan_(probe, settings),
      needle_(plan_),
      tables_(plan_, settings.look == Look::Thesis) {
  if (settings.look == Look::Thesis) thesis_.emplace(plan_);
  if (thesis_)
    stages_ = {{"upload"}, {"structures"}, {"echoes"}, {"beam"}, {"envelope"}, {"read-back"}};
  else
    stages_ = {{"upload"},     {"contact"},      {"structures"}, {"losses"},   {"echoes"},
               {"axial beam"}, {"lateral beam"}, {"envelope"},   {"read-back"}};
}

Result<std::unique_ptr<CardFrame>> CardFrame::make(std::shared_ptr<const Device> device, const Probe& probe,
                                                   const ImagingSettings& settings) {
  const auto current = device->context().use();
  if (!current) return tl::unexpected(current.error());
  std::unique_ptr<CardFrame> frame(new CardFrame(std::move(device), probe, settings));
  if (auto ok = frame->allocate(*current); !ok) return tl::unexpected(ok.error());
  return frame;
}

Result<void> CardFrame::allocate(const gpu::CurrentContext& current) {
  Result<void> ok;
  const auto keep = [&](Result<gpu::Buffer> made, gpu::Buffer& buffer) {
    if (!ok) return;
    if (made)
      buffer = std::move(*made);
    else
      ok = tl::unexpected(made.error());
  };
  const auto room = [&](std::size_t bytes, gpu::Buffer& buffer) {
    if (ok) keep(gpu::Buffer::make(current, bytes), buffer);
  };
  const auto fill = [&](const auto& values, gpu::Buffer& buffer) {
    if (ok) keep(gpu::Buffer::of(current, std::span(values)), buffer);
  };
  const std::size_t planes = plan_.settings.elevationPlanes, columns = plan_.nodeColumns, rows = plan_.nodeRows;
  const std::size_t gates = std::size_t(plan_.gates) * plan_.lines, nodes = planes * rows * columns;
  const std::size_t components = std::size_t(tables_.block.looks) * tables_.block.parts;
  const std::size_t look = sizeof(float) * plan_.grid.samples() * plan_.lines;
  fill(tables_.plan, planTable_), fill(tables_.kernels, kernels_);
  room(sizeof(FrameBlock), block_);
  room(columns * 2 * sizeof(float), contacts_), room(rows * columns * 2 * sizeof(float), shifts_);
  room(nodes * kNodeBytes, nodes_);
  room(components * gates * sizeof(float), echo_), room(components * gates * sizeof(float), blurred_);
  room(tables_.block.looks * look, envelope_);
  needleWords_.reserve((4 + 2 * planes + plan_.gates) * plan_.lines);
  room(needleWords_.capacity() * sizeof(float), needleBuffer_);
  if (thesis_) {
    room(sizeof(ThesisBlock), thesisBlock_);
    room(planes * thesis_->mapRows * columns * sizeof(Float4), map_);
  } else {
    fill(tables_.repeats, repeats_);
    room(nodes * kCellBytes, cells_), room(planes * gates * kSampleBytes, samples_);
    room(planes * gates * kCrossingBytes, crossings_), room(plan_.lines * sizeof(int), gasGates_);
    room((gates + plan_.lines) * sizeof(float), reaching_);
    room(ApertureRays::kCount * gates * sizeof(float), aperture_);
  }
  if (!ok) return ok;
  auto watch = gpu::Stopwatch::make(current, static_cast<int>(stages_.size()) - 1);
  if (!watch) return tl::unexpected(watch.error());
  watch_ = std::move(*watch);
  auto readBack = gpu::ReadBack::make(current, look);
  if (!readBack) return tl::unexpected(readBack.error());
  readBack_ = std::move(*readBack);
  return {};
}

Result<void> CardFrame::upload(const gpu::CurrentContext& current, const AcousticScene::Impl& scene,
                               const Transform& patientFromProbe, const PlaneDisplacement& displacement) {
  FrameBlock& block = tables_.block;
  auto volumes = device_->scenes().of(current, scene);
  if (!volumes) return tl::unexpected(volumes.error());
  volumes_ = std::move(*volumes);
  setScene(scene, block);
  setPose(plan_, scene, patientFromProbe, block);
  block.lungSlide_voxels = static_cast<float>(displacement.lung.slide_mm / patchTile().voxel_mm.x);
  const auto& detached_mm = displacement.lung.detached_mm;
  block.lungDetached_mm = {static_cast<float>(detached_mm[0]), static_cast<float>(detached_mm[1]), 0, 0};
  if (auto ok = uploadDisplacement(current, displacement, block, displacement_); !ok) return ok;
  pointEchoes_ = 0;
  if (!thesis_ && !scene.points.empty()) {
    const std::vector<Float4> points = pointTable(plan_, scene, patientFromProbe, displacement);
    if (points.size() > pointCapacity_) {
      auto buffer = gpu::Buffer::make(current, points.size() * sizeof(Float4));
      if (!buffer) return tl::unexpected(buffer.error());
      points_ = std::move(*buffer), pointCapacity_ = points.size();
    }
    if (!points.empty()) points_.write(current, bytesOf(points));
    pointEchoes_ = static_cast<int>(points.size());
  }
  block_.write(current, bytesOfOne(block));
  if (thesis_) thesisBlock_.write(current, bytesOfOne(thesisBlock(plan_, *thesis_, scene, patientFromProbe)));
  return {};
}

void CardFrame::uploadNeedle(const gpu::CurrentContext& current) {
  if (!needle_.present()) return;
  setNeedle(plan_, needle_, needleWords_);
  needleBuffer_.write(current, bytesOf(needleWords_));
}

void CardFrame::bindShared(const gpu::CurrentContext& current) const {
  block_.bindUniform(current, 0);
  if (thesis_) thesisBlock_.bindUniform(current, 1);
  displacement_.bind(current, 0);
  volumes_->bindStorage(current, kSceneSlot);
  device_->tiles().bindStorage(current, kTilesSlot);
  planTable_.bindStorage(current, kPlanSlot);
  contacts_.bindStorage(current, kContactsSlot);
  shifts_.bindStorage(current, kShiftsSlot);
}

void CardFrame::traceCoherent(const gpu::CurrentContext& current) {
  const int planes = plan_.settings.elevationPlanes, lines = groupsOfLines(), gates = (plan_.gates + 1) / 2;
  const int columns = (plan_.nodeColumns + 31) / 32, rows = (plan_.nodeRows + 1) / 2;
  device_->run(current, Stage::Contact, {}, columns);
  endPart(current);
  device_->run(current, Stage::Nodes, {{5, &nodes_}}, columns, rows, planes);
  device_->run(current, Stage::Cells, {{5, &nodes_}, {6, &cells_}}, columns, rows, planes);
  device_->run(current, Stage::Tissue, {{5, &cells_}, {6, &samples_}}, lines, gates, planes);
  device_->run(current, Stage::Crossings, {{5, &cells_}, {6, &samples_}, {7, &crossings_}}, lines, gates, planes);
  endPart(current);
  device_->run(current, Stage::Levels, {{5, &samples_}, {6, &crossings_}, {7, &gasGates_}}, (plan_.lines + 15) / 16, 1,
               planes);
  device_->run(current, Stage::Reaching, {{5, &samples_}, {7, &reaching_}}, lines, plan_.gates / 2 + 1);
  device_->run(current, Stage::Aperture, {{5, &reaching_}, {7, &aperture_}}, ApertureRays::kCount);
  device_->run(current, Stage::Penumbra, {{5, &samples_}, {6, &aperture_}, {7, &reaching_}}, lines, gates);
  if (needle_.present())
    device_->run(current, Stage::NeedleShadow, {{5, &samples_}, {6, &needleBuffer_}, {7, &crossings_}}, lines, gates,
                 planes);
  endPart(current);
  device_->run(current, Stage::Echoes, {{5, &samples_}, {6, &crossings_}, {7, &echo_}}, lines, gates);
  if (plan_.settings.effects.reverberation) {
    device_->run(current, Stage::Gas, {{5, &samples_}, {6, &gasGates_}}, lines, gates);
    device_->run(current, Stage::Reverberate, {{5, &gasGates_}, {6, &repeats_}, {7, &echo_}}, lines, gates);
  }
  if (pointEchoes_ > 0) device_->run(current, Stage::Points, {{5, &points_}, {7, &echo_}}, pointEchoes_);
  if (needle_.present())
    device_->run(current, Stage::NeedleEchoes, {{5, &samples_}, {6, &needleBuffer_}, {7, &echo_}}, lines, gates);
  endPart(current);
  const int components = 2 * tables_.block.looks;
  device_->run(current, Stage::Axial, {{5, &kernels_}, {6, &echo_}, {7, &blurred_}}, lines, gates, components);
  endPart(current);
  device_->run(current, Stage::Lateral, {{5, &kernels_}, {6, &blurred_}, {7, &echo_}}, lines, gates, components);
  endPart(current);
}

void CardFrame::traceThesis(const gpu::CurrentContext& current) {
  const int planes = plan_.settings.elevationPlanes, lines = groupsOfLines(), gates = (plan_.gates + 1) / 2;
  const int columns = (plan_.nodeColumns + 31) / 32;
  device_->run(current, Stage::Contact, {}, columns);
  device_->run(current, Stage::Nodes, {{5, &nodes_}}, columns, (plan_.nodeRows + 1) / 2, planes);
  device_->run(current, Stage::ThesisMap, {{5, &nodes_}, {6, &map_}}, columns, (thesis_->mapRows + 1) / 2, planes);
  endPart(current);
  device_->run(current, Stage::ThesisEchoes, {{5, &map_}, {7, &echo_}}, (plan_.lines + 15) / 16);
  endPart(current);
  device_->run(current, Stage::ThesisTail, {{5, &kernels_}, {6, &echo_}, {7, &blurred_}}, lines, gates);
  device_->run(current, Stage::Lateral, {{5, &kernels_}, {6, &blurred_}, {7, &echo_}}, lines, gates);
  endPart(current);
}

/// While one look is copied, the next is computed.
Result<void> CardFrame::readEnvelope(const gpu::CurrentContext& current, EnvelopeFrame& envelope) {
  const int looks = tables_.block.looks;
  const std::size_t count = std::size_t(plan_.lines) * plan_.grid.samples();
  int read = 0;
  const auto finish = [&] {
    return readBack_.finish(current, std::as_writable_bytes(std::span(envelope.look(read++), count)));
  };
  for (int look = 0; look < looks; ++look) {
    device_->program(Stage::Envelope).setInt(current, "look", look);
    device_->run(current, Stage::Envelope, {{5, &kernels_}, {6, &echo_}, {7, &envelope_}}, groupsOfLines(),
                 (plan_.grid.samples() + 1) / 2);
    if (readBack_.full())
      if (auto ok = finish(); !ok) return ok;
    readBack_.begin(current, envelope_, look * count * sizeof(float), count * sizeof(float));
  }
  endPart(current);
  while (read < looks)
    if (auto ok = finish(); !ok) return ok;
  return {};
}

Result<void> CardFrame::render(const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                               const PlaneDisplacement& displacement, const Instruments& instruments,
                               EnvelopeFrame& envelope) {
  const auto current = device_->context().use();
  if (!current) return tl::unexpected(current.error());
  envelope.resize(plan_.lines, plan_.grid.samples(), tables_.block.looks);
  const auto start = Clock::now();
  if (auto ok = upload(*current, scene, patientFromProbe, displacement); !ok) return ok;
  if (!thesis_) needle_.place(instruments, scene.field, patientFromProbe, displacement);
  uploadNeedle(*current);
  bindShared(*current);
  stages_.front().ms = msSince(start);
  partsDone_ = 0;
  endPart(*current);
  if (thesis_)
    traceThesis(*current);
  else
    traceCoherent(*current);
  if (auto ok = readEnvelope(*current, envelope); !ok) return ok;
  noteTimes(*current, msSince(start));
  return {};
}

void CardFrame::noteTimes(const gpu::CurrentContext& current, double frame_ms) {
  double known_ms = stages_.front().ms;
  for (int part = 1; part + 1 < static_cast<int>(stages_.size()); ++part)
    known_ms += stages_[part].ms = watch_.between_ms(current, part - 1, part);
  stages_.back().ms = std::max(frame_ms - known_ms, 0.0);
}

}  // namespace insonate::glsl
