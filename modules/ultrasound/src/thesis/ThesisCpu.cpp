#include "thesis/ThesisCpu.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace insonate::thesis {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kSampleChunk = 64;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

int roundedUp(int n, int multiple) {
  return (n + multiple - 1) / multiple * multiple;
}

}  // namespace

ThesisCpu::ThesisCpu(const Probe& probe, const ImagingSettings& settings)
    : plan_(probe, settings),
      thesis_(plan_),
      lateralKernel_(plan_.lateralKernel.begin(), plan_.lateralKernel.end()),
      contacts_(plan_.nodeColumns),
      stages_{{"contact"}, {"structures"}, {"echoes"}, {"tangential blur"}} {
  const int paddedLines = roundedUp(plan_.lines, kBlockLines);
  echo_.margin = roundedUp(plan_.maxLateralRadius, 16);
  echo_.width = paddedLines + 2 * echo_.margin;
  echo_.values = hwy::AllocateAligned<float>(std::size_t(plan_.gates) * echo_.width);
  provideWorkspaces(tbb::info::default_concurrency() + 1);
  input_.plan = &plan_;
  input_.thesis = &thesis_;
  input_.columns.resize(plan_.nodeColumns);
  input_.probeColumns.resize(plan_.nodeColumns);
  input_.columnGap_mm.resize(plan_.nodeColumns);
  input_.lineLevel_dB.resize(paddedLines);
  for (int row = 0; row < plan_.nodeRows; ++row)
    input_.contactDecay.push_back(
        static_cast<float>(std::exp(-plan_.range_mm(row * plan_.cellGates) / acoustics::kContactDepth_mm)));
  for (const double offset_sd : plan_.planeOffset_sd)
    for (int row = 0; row < plan_.nodeRows; ++row)
      input_.elevation_mm.push_back(
          static_cast<float>(offset_sd * plan_.elevationSd_mm[std::min(row * plan_.cellGates, plan_.gates - 1)]));
}

/// One for each thread of the arena; a larger arena adds its own once.
void ThesisCpu::provideWorkspaces(int threads) {
  while (static_cast<int>(workspaces_.size()) < threads) {
    workspaces_.push_back(std::make_unique<Workspace>());
    workspaces_.back()->ring = hwy::AllocateAligned<float>(std::size_t(2) * echo_.width);
  }
}

ThesisCpu::Workspace& ThesisCpu::workspace() {
  return *workspaces_[tbb::this_task_arena::current_thread_index()];
}

void ThesisCpu::setGeometry(const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                            const PlaneDisplacement& displacement) {
  tbb::parallel_for(0, plan_.nodeColumns, [&](int column) {
    const double line = column * plan_.cellLines;
    const Ray ray{plan_.grid.origin(line), plan_.grid.direction(line)};
    input_.probeColumns[column] = ray;
    input_.columns[column] = {patientFromProbe * ray.origin_mm, patientFromProbe.linear * ray.direction};
    contacts_[column] = contactOf(scene.field, patientFromProbe, displacement, ray.origin_mm, ray.direction);
    input_.columnGap_mm[column] =
        plan_.settings.conformingContact ? static_cast<float>(contacts_[column].gap_mm) : 0.0F;
  });
  for (std::size_t l = 0; l < input_.lineLevel_dB.size(); ++l) {
    const int line = std::min(static_cast<int>(l), plan_.lines - 1), column = line / plan_.cellLines;
    const double t = double(line % plan_.cellLines) / plan_.cellLines;
    const double strength =
        contacts_[column].strength + t * (contacts_[column + 1].strength - contacts_[column].strength);
    input_.lineLevel_dB[l] = static_cast<float>(20 * std::log10(std::max(strength, 1e-9)));
  }
}

void ThesisCpu::render(const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                       const PlaneDisplacement& displacement, EnvelopeFrame& envelope) {
  envelope.resize(plan_.lines, plan_.grid.samples(), 1);
  provideWorkspaces(tbb::this_task_arena::max_concurrency());
  for (auto& work : workspaces_) work->times = {};
  const auto start = Clock::now();
  input_.scene = &scene;
  input_.channels = channelAcoustics(plan_.settings, scene);
  input_.elevationAxis = patientFromProbe.linear.column[1];
  input_.noiseSeed = noiseSeed(patientFromProbe, plan_.settings.time_s);
  input_.displacement = displacement.empty() ? nullptr : &displacement;
  input_.patientFromProbe = patientFromProbe.linear;
  setGeometry(scene, patientFromProbe, displacement);
  stages_[0].ms = millisecondsSince(start);

  const int blocks = (plan_.lines + kBlockLines - 1) / kBlockLines;
  tbb::parallel_for(0, blocks, [&](int block) {
    Workspace& work = workspace();
    traceBlock(input_, block * kBlockLines, work.buffers, echo_, work.times);
  });
  const int chunks = (plan_.grid.samples() + kSampleChunk - 1) / kSampleChunk;
  tbb::parallel_for(0, chunks, [&](int chunk) {
    const auto chunkStart = Clock::now();
    Workspace& work = workspace();
    blurSamples(plan_, lateralKernel_, echo_, chunk * kSampleChunk,
                std::min((chunk + 1) * kSampleChunk, plan_.grid.samples()), work.ring.get(), envelope.look(0));
    work.times.blur += millisecondsSince(chunkStart);
  });

  for (std::size_t s = 1; s < stages_.size(); ++s) stages_[s].ms = 0;
  for (const auto& work : workspaces_) {
    stages_[1].ms += work->times.map;
    stages_[2].ms += work->times.trace;
    stages_[3].ms += work->times.blur;
  }
}

}  // namespace insonate::thesis
