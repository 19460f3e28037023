#include "cpu/CpuEngine.h"

#include "cpu/ApertureTransmission.h"
#include "cpu/BeamKernel.h"
#include "cpu/TraceInput.h"
#include "model/Boundary.h"
#include "model/PlaneShift.h"
#include "model/PointEchoes.h"
#include "model/Reverberation.h"
#include "thesis/ThesisCpu.h"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <cmath>
#include <optional>

namespace insonate {
namespace {

using namespace cpu;

constexpr int kSampleChunk = 64;

int roundedUp(int n, int multiple) {
  return (n + multiple - 1) / multiple * multiple;
}

/// Memory of one thread.
struct Workspace {
  TraceBuffers trace;
  LateralBuffers lateral;
  std::vector<float> above;     ///< one scanline's echoes above gas
  std::vector<float> strength;  ///< of the reverberation of these echoes
  TraceTimes_ms times;
  double axial_ms = 0, lateral_ms = 0;
};

void setRay(RayArrays& rays, std::size_t at, Vec3 origin, Vec3 direction) {
  rays.x[at] = static_cast<float>(origin.x), rays.dx[at] = static_cast<float>(direction.x);
  rays.y[at] = static_cast<float>(origin.y), rays.dy[at] = static_cast<float>(direction.y);
  rays.z[at] = static_cast<float>(origin.z), rays.dz[at] = static_cast<float>(direction.z);
}

class StopWatch {
 public:
  double ms() const { return std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

class CpuEngine final : public Engine {
 public:
  std::string_view name() const override { return "cpu"; }
  void prepare(const Probe& probe, const ImagingSettings& settings) override;
  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              const Instruments& instruments, EnvelopeFrame& envelope) override;
  const std::vector<Stage>& stages() const override { return thesis_ ? thesis_->stages() : stages_; }

 private:
  void prepareInput(const FramePlan& plan, int paddedLines);
  void provideWorkspaces(int threads);
  void setGeometry(const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                   const PlaneDisplacement& displacement);
  void setScanlines(const Transform& patientFromProbe, const ScattererLattice& lattice);
  void setTextureRays(const TextureFrame& frame, const Transform& patientFromProbe, TextureRays& rays) const;
  void traceLines(int block);
  void finishLines(int block, const std::vector<PointEcho>& points);
  Vec3 surfaceOfGas(int line, int gate) const;
  Vec3 shiftOf(int line, int gate) const;
  void reverberate(int firstLine, BlockEchoes& echoes, Workspace& work) const;
  void addNeedle(int firstLine, BlockEchoes& echoes) const;

  std::unique_ptr<thesis::ThesisCpu> thesis_;  ///< if the settings select the thesis style; the rest is then unused
  std::optional<FramePlan> plan_;
  std::optional<Reverberation> behindGas_;
  LungMotion lung_;  ///< PlaneDisplacement::lung of the frame
  std::optional<NeedleEchoes> needle_;
  std::vector<Vec3> origins_, directions_;  ///< of the scanlines, in the probe's frame
  BeamTables tables_;
  TraceInput input_;
  EchoPlane echo_;
  std::vector<BlockEchoes> blocks_;
  ApertureTransmission transmission_;
  std::vector<std::unique_ptr<Workspace>> workspaces_;  ///< by thread of the arena
  std::vector<Contact> contacts_;
  std::vector<Stage> stages_;
};

void CpuEngine::prepare(const Probe& probe, const ImagingSettings& settings) {
  thesis_ = settings.look == Look::Thesis ? std::make_unique<thesis::ThesisCpu>(probe, settings) : nullptr;
  if (thesis_) return;
  const FramePlan& plan = plan_.emplace(probe, settings);
  behindGas_.emplace(plan);
  needle_.emplace(plan);
  origins_.clear(), directions_.clear();
  for (int line = 0; line < plan.lines; ++line) {
    origins_.push_back(plan.grid.origin(line));
    directions_.push_back(plan.grid.direction(line));
  }
  tables_ = BeamTables(plan);
  const int components = 2 * settings.looks;
  const int paddedLines = roundedUp(plan.lines, kBlockLines);

  echo_.margin = roundedUp(plan.maxLateralRadius, 16);
  echo_.width = paddedLines + 2 * echo_.margin;
  const std::size_t echoSize = std::size_t(components) * plan.gates * echo_.width;
  echo_.values = hwy::AllocateAligned<float>(echoSize);
  std::fill_n(echo_.values.get(), echoSize, 0.0F);

  transmission_ = ApertureTransmission(plan);
  blocks_.clear();
  blocks_.resize(paddedLines / kBlockLines);
  for (BlockEchoes& block : blocks_) {
    block.echo = hwy::AllocateAligned<float>(std::size_t(components) * plan.gates * kBlockLines);
    block.boundaries = hwy::AllocateAligned<float>(std::size_t(plan.gates) * kBlockLines);
    block.level = hwy::AllocateAligned<float>(std::size_t(plan.gates) * kBlockLines);
  }
  workspaces_.clear();
  provideWorkspaces(tbb::info::default_concurrency() + 1);
  contacts_.resize(plan.nodeColumns);
  prepareInput(plan, paddedLines);
  stages_ = {{"contact"}, {"structures"}, {"echoes"}, {"aperture"}, {"axial beam"}, {"lateral beam"}};
}

void CpuEngine::prepareInput(const FramePlan& plan, int paddedLines) {
  const ImagingSettings& settings = plan.settings;
  input_ = {};
  input_.plan = &plan;
  input_.lines.resize(paddedLines);
  input_.latticeLines.resize(paddedLines);
  for (auto& sides : input_.textureRays)
    for (TextureRays& rays : sides) rays.line.resize(paddedLines), rays.facing.resize(paddedLines);
  // Vectors may extend beyond the last column.
  const int paddedColumns = paddedLines / plan.cellLines + kMaxColumns;
  input_.columns.resize(paddedColumns);
  input_.probeColumns.resize(paddedColumns);
  for (int c = 0; c < paddedColumns; ++c) {
    const double line = std::min(c, plan.nodeColumns - 1) * plan.cellLines;
    setRay(input_.probeColumns, c, plan.grid.origin(line), plan.grid.direction(line));
  }
  input_.lineGap_mm.resize(paddedLines);
  input_.lineStrength.resize(paddedLines);
  input_.columnGap_mm.resize(paddedColumns);
  const auto decayAt = [&](double gate) {
    return static_cast<float>(std::exp(-plan.range_mm(gate) / acoustics::kContactDepth_mm));
  };
  for (int row = 0; row < plan.nodeRows; ++row) input_.contactDecay.push_back(decayAt(row * plan.cellGates));
  for (int gate = 0; gate < plan.gates; ++gate) input_.contactDecay.push_back(decayAt(gate));
  for (int p = 0; p < settings.elevationPlanes; ++p)
    for (int g = 0; g < plan.gates; ++g) {
      input_.elevation_mm.push_back(static_cast<float>(plan.planeOffset_sd[p] * plan.elevationSd_mm[g]));
      input_.scatterScale.push_back(
          settings.effects.speckle ? static_cast<float>(plan.scatterScale[g] * plan.scatterWeight[p]) : 0.0F);
    }
}

/// One for each thread of the arena; a larger arena adds its own once.
void CpuEngine::provideWorkspaces(int threads) {
  while (static_cast<int>(workspaces_.size()) < threads) {
    auto work = std::make_unique<Workspace>();
    work->lateral.ring = hwy::AllocateAligned<float>(std::size_t(2) * plan_->settings.looks * 4 * echo_.width);
    work->above.resize(plan_->gates);
    work->strength.resize(behindGas_->strengths());
    workspaces_.push_back(std::move(work));
  }
}

void CpuEngine::setGeometry(const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                            const PlaneDisplacement& displacement) {
  const FramePlan& plan = *plan_;
  tbb::parallel_for(0, plan.nodeColumns, [&](int column) {
    const double line = column * plan.cellLines;
    contacts_[column] =
        contactOf(scene.field, patientFromProbe, displacement, plan.grid.origin(line), plan.grid.direction(line));
  });
  for (std::size_t c = 0; c < input_.columnGap_mm.size(); ++c) {
    const int column = std::min(static_cast<int>(c), plan.nodeColumns - 1);
    const double line = column * plan.cellLines;
    setRay(input_.columns, c, patientFromProbe * plan.grid.origin(line),
           patientFromProbe.linear * plan.grid.direction(line));
    input_.columnGap_mm[c] = plan.settings.conformingContact ? static_cast<float>(contacts_[column].gap_mm) : 0.0F;
  }
  const auto f = [](double v) { return static_cast<float>(v); };
  const Vec3 elevation = patientFromProbe.linear.column[1];
  const ScattererLattice lattice(elevation, plan.latticePitch_mm, plan.latticeElevationPitch_mm, plan.specklePattern);
  const Vec3 latticeElevation = lattice.latticeFromPatient * elevation;
  input_.scene = &scene;
  input_.displacement = displacement.empty() ? nullptr : &displacement;
  lung_ = displacement.lung;
  input_.patientAxes = PlaneAxes(patientFromProbe.linear);
  input_.latticeAxes = PlaneAxes(lattice.latticeFromPatient * patientFromProbe.linear);
  input_.elevationX = f(elevation.x), input_.elevationY = f(elevation.y), input_.elevationZ = f(elevation.z);
  input_.latticeElevationX = f(latticeElevation.x), input_.latticeElevationY = f(latticeElevation.y),
  input_.latticeElevationZ = f(latticeElevation.z);
  input_.latticeSeed = lattice.seed;
  const Transform& node = scene.field.nodeFromPatient;
  input_.nodeFromPatient = FloatMatrix(node.linear);
  input_.nodeOffsetX = f(node.offset.x), input_.nodeOffsetY = f(node.offset.y), input_.nodeOffsetZ = f(node.offset.z);
  setScanlines(patientFromProbe, lattice);
  for (int c = 0; c < scene.field.channels; ++c)
    if (input_.texturedChannels >> c & 1U)
      for (int side = 0; side < 2; ++side)
        setTextureRays(scene.textureFrames[scene.field.label[c]][side], patientFromProbe, input_.textureRays[c][side]);
}

void CpuEngine::setScanlines(const Transform& patientFromProbe, const ScattererLattice& lattice) {
  const FramePlan& plan = *plan_;
  for (std::size_t l = 0; l < input_.lines.x.size(); ++l) {
    const int line = std::min(static_cast<int>(l), plan.lines - 1);
    const Vec3 origin = patientFromProbe * origins_[line];
    const Vec3 direction = patientFromProbe.linear * directions_[line];
    setRay(input_.lines, l, origin, direction);
    setRay(input_.latticeLines, l, lattice.latticeFromPatient * origin, lattice.latticeFromPatient * direction);
    const int column = line / plan.cellLines;
    const double t = double(line - column * plan.cellLines) / plan.cellLines;
    const Contact &left = contacts_[column], &right = contacts_[column + 1];
    const double gap_mm = left.gap_mm + t * (right.gap_mm - left.gap_mm);
    const double strength = left.strength + t * (right.strength - left.strength);
    input_.lineGap_mm[l] = plan.settings.conformingContact ? static_cast<float>(gap_mm) : 0.0F;
    input_.lineStrength[l] = static_cast<float>(std::max(strength, 1e-9));
  }
}

void CpuEngine::setTextureRays(const TextureFrame& frame, const Transform& patientFromProbe, TextureRays& rays) const {
  const Transform tileFromProbe = frame.tileFromPatient * patientFromProbe;
  const Vec3 thinAxis = transposed(patientFromProbe.linear) * frame.thinAxis;
  const Vec3 elevation = tileFromProbe.linear.column[1];
  constexpr double kHalf = 0.5 - TextureTile::kRounding_voxels;
  rays.axes = PlaneAxes(tileFromProbe.linear);
  rays.elevationX = static_cast<float>(elevation.x), rays.elevationY = static_cast<float>(elevation.y),
  rays.elevationZ = static_cast<float>(elevation.z);
  for (std::size_t l = 0; l < rays.facing.size(); ++l) {
    const int line = std::min(static_cast<int>(l), plan_->lines - 1);
    const Vec3 direction = directions_[line];
    setRay(rays.line, l, tileFromProbe * origins_[line] - Vec3{kHalf, kHalf, kHalf}, tileFromProbe.linear * direction);
    rays.facing[l] = static_cast<float>(sheetFacing(dot(direction, thinAxis)));
  }
}

Vec3 CpuEngine::surfaceOfGas(int line, int gate) const {
  const auto rest_mm = static_cast<float>(plan_->range_mm(gate));
  const float range_mm = rest_mm + input_.lineGap_mm[line] * input_.contactDecay[plan_->nodeRows + gate];
  const auto at = [&](const std::vector<float>& origin, const std::vector<float>& direction) {
    return double(origin[line] + direction[line] * range_mm);
  };
  const Vec3 seen{at(input_.lines.x, input_.lines.dx), at(input_.lines.y, input_.lines.dy),
                  at(input_.lines.z, input_.lines.dz)};
  return input_.displacement ? seen + shiftOf(line, gate) : seen;
}

/// Displacement from the displayed place of tissue to its rest place, in the patient, interpolated between the nodes of
/// its cell as in the kernels.
Vec3 CpuEngine::shiftOf(int line, int gate) const {
  const FramePlan& plan = *plan_;
  const int row = gate / plan.cellGates, column = line / plan.cellLines;
  const auto node = [&](int r, int c) {
    const double decay = input_.contactDecay[r], range_mm = plan.range_mm(r * plan.cellGates);
    const Vec3 seen = plan.grid.origin(c * plan.cellLines) +
                      plan.grid.direction(c * plan.cellLines) * (range_mm + input_.columnGap_mm[c] * decay);
    return shiftAt(*input_.displacement, seen.x, seen.z);
  };
  const double down = double(gate - row * plan.cellGates) / plan.cellGates;
  const double across = double(line - column * plan.cellLines) / plan.cellLines;
  const auto along = [&](int r) { return node(r, column) * (1 - across) + node(r, column + 1) * across; };
  const Vec3 shift = along(row) * (1 - down) + along(row + 1) * down;
  const auto &lateral = input_.patientAxes.lateral, &axial = input_.patientAxes.axial;
  return {lateral.x * shift.x + axial.x * shift.z, lateral.y * shift.x + axial.y * shift.z,
          lateral.z * shift.x + axial.z * shift.z};
}

void CpuEngine::reverberate(int firstLine, BlockEchoes& echoes, Workspace& work) const {
  const FramePlan& plan = *plan_;
  for (int l = 0; l < kBlockLines; ++l) {
    const int gas = echoes.gasGate[l];
    if (gas <= 0) continue;
    behindGas_->strengthsAt(surfaceOfGas(firstLine + l, gas), *input_.scene, lung_, work.strength);
    for (int c = 0; c < 2 * plan.settings.looks; ++c) {
      float* echo = echoes.echo.get() + std::size_t(c) * plan.gates * kBlockLines + l;
      for (int g = 0; g <= gas; ++g) work.above[g] = echo[std::size_t(g) * kBlockLines];
      for (int g = gas + Reverberation::kFirstGate; g < plan.gates; ++g)
        for (const Reverberation::Repeat& r : behindGas_->at(g - gas))
          if (r.gatesAbove <= gas)
            echo[std::size_t(g) * kBlockLines] += r.share * work.strength[r.strength] * work.above[gas - r.gatesAbove];
    }
  }
}

void CpuEngine::addNeedle(int firstLine, BlockEchoes& echoes) const {
  const FramePlan& plan = *plan_;
  for (int l = 0; l < std::min(kBlockLines, plan.lines - firstLine); ++l)
    needle_->addTo(
        firstLine + l,
        [&](int gate) { return 20 * std::log10(std::max(echoes.level[std::size_t(gate) * kBlockLines + l], 1e-30F)); },
        [&](int gate, float amplitude) {
          for (int look = 0; look < plan.settings.looks; ++look)
            echoes.echo[(std::size_t(2) * look * plan.gates + gate) * kBlockLines + l] += amplitude;
        });
}

void CpuEngine::traceLines(int block) {
  Workspace& work = *workspaces_[tbb::this_task_arena::current_thread_index()];
  traceBlock(input_, block * kBlockLines, work.trace, blocks_[block], transmission_, work.times);
}

void CpuEngine::finishLines(int block, const std::vector<PointEcho>& points) {
  const FramePlan& plan = *plan_;
  Workspace& work = *workspaces_[tbb::this_task_arena::current_thread_index()];
  const StopWatch watch;
  const int firstLine = block * kBlockLines;
  BlockEchoes& echoes = blocks_[block];
  transmission_.light(firstLine, echoes);
  reverberate(firstLine, echoes, work);
  if (input_.needle) addNeedle(firstLine, echoes);
  for (const PointEcho& point : points)
    if (point.line >= firstLine && point.line < firstLine + kBlockLines)
      for (int look = 0; look < plan.settings.looks; ++look)
        echoes.echo[(std::size_t(2) * look * plan.gates + point.gate) * kBlockLines + point.line - firstLine] +=
            point.amplitude;
  // Beyond the last scanline the block contains copies of it; the lateral kernel requires zeros there.
  for (std::size_t row = 0; row < std::size_t(2) * plan.settings.looks * plan.gates; ++row)
    for (int l = std::max(0, plan.lines - firstLine); l < kBlockLines; ++l) echoes.echo[row * kBlockLines + l] = 0;
  convolveAxially(plan, tables_, echoes.echo.get(), firstLine, echo_);
  work.axial_ms += watch.ms();
}

void CpuEngine::render(const AcousticScene& sceneHandle, const Transform& patientFromProbe,
                       const PlaneDisplacement& displacement, const Instruments& instruments, EnvelopeFrame& envelope) {
  if (thesis_) return thesis_->render(sceneHandle.impl(), patientFromProbe, displacement, envelope);
  const FramePlan& plan = *plan_;
  const AcousticScene::Impl& scene = sceneHandle.impl();
  envelope.resize(plan.lines, plan.grid.samples(), plan.settings.looks);
  provideWorkspaces(tbb::this_task_arena::max_concurrency());
  for (auto& work : workspaces_) work->times = {}, work->axial_ms = work->lateral_ms = 0;

  const StopWatch watch;
  setChannels(scene, input_);
  setGeometry(scene, patientFromProbe, displacement);
  needle_->place(instruments, scene.field, patientFromProbe, displacement);
  input_.needle = needle_->present() ? &*needle_ : nullptr;
  const std::vector<PointEcho> points =
      scene.points.empty() ? std::vector<PointEcho>{} : pointEchoes(plan, scene.points, patientFromProbe, displacement);
  stages_[0].ms = watch.ms();

  const int blocks = static_cast<int>(blocks_.size());
  tbb::parallel_for(0, blocks, [&](int block) { traceLines(block); });
  const StopWatch raysWatch;
  transmission_.followRays();
  stages_[3].ms = raysWatch.ms();
  tbb::parallel_for(0, blocks, [&](int block) { finishLines(block, points); });
  const int chunks = (plan.grid.samples() + kSampleChunk - 1) / kSampleChunk;
  tbb::parallel_for(0, chunks, [&](int chunk) {
    const StopWatch chunkWatch;
    Workspace& work = *workspaces_[tbb::this_task_arena::current_thread_index()];
    convolveLaterally(plan, tables_, echo_, chunk * kSampleChunk,
                      std::min((chunk + 1) * kSampleChunk, plan.grid.samples()), work.lateral,
                      envelope.amplitude.data());
    work.lateral_ms += chunkWatch.ms();
  });

  for (const int s : {1, 2, 4, 5}) stages_[s].ms = 0;
  for (const auto& work : workspaces_) {
    stages_[1].ms += work->times.nodes;
    stages_[2].ms += work->times.gates;
    stages_[4].ms += work->axial_ms;
    stages_[5].ms += work->lateral_ms;
  }
}

}  // namespace

std::unique_ptr<Engine> makeCpuEngine() {
  return std::make_unique<CpuEngine>();
}

}  // namespace insonate
