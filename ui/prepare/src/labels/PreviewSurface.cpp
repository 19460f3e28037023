#include "PreviewSurface.h"

#include "LabelPreview.h"

#include <insonate/surface/ExtractSurface.h>

#include <QFutureWatcher>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>
#include <array>
#include <exception>
#include <string_view>
#include <utility>

namespace insonate::prepare {
namespace {

/// Coarse enough to follow a slider, since a preview is temporary.
constexpr SurfaceOptions kCoarse{.smoothing_mm = 0, .detail_mm = 3};
/// Size of the voxels for a preview.
constexpr double kVoxel_mm = 1;

/// One voxel for each block not larger than kVoxel_mm, near its center.
LabelMap thinned(const LabelMap& labels) {
  std::array<int, 3> step{};
  VolumeGeometry grid = labels.geometry;
  Vec3 first;
  for (int axis = 0; axis < 3; ++axis) {
    step[axis] = std::clamp(int(kVoxel_mm / grid.spacing_mm[axis]), 1, grid.size[axis]);
    grid.size[axis] /= step[axis];
    grid.spacing_mm[axis] *= step[axis];
    first[axis] = step[axis] / 2;
  }
  grid.origin_mm = labels.geometry.patientFromIndex() * first;
  LabelMap thin(grid);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j) {
      const std::uint8_t* voxel = &labels.at(step[0] / 2, j * step[1] + step[1] / 2, k * step[2] + step[2] / 2);
      for (int i = 0; i < grid.size[0]; ++i, voxel += step[0]) thin.at(i, j, k) = *voxel;
    }
  return thin;
}

std::shared_ptr<const Mesh> surfaceOf(const Proposal& proposal, std::uint8_t label, const std::atomic<bool>& stop) {
  try {
    if (proposal.box.empty()) return nullptr;
    auto mesh =
        extractSurface(thinned(proposal.labels), label, kCoarse, [&stop](std::string_view, double) { return !stop; });
    return mesh ? std::make_shared<const Mesh>(std::move(*mesh)) : nullptr;
  } catch (const std::exception&) {
    // The slices still show the preview.
    return nullptr;
  }
}

}  // namespace

PreviewSurface::PreviewSurface(LabelPreview& preview, QObject* parent) : QObject(parent), preview_(preview) {
  connect(&preview_, &LabelPreview::changed, this, [this] { follow(); });
}

PreviewSurface::~PreviewSurface() {
  if (stop_) *stop_ = true;
}

void PreviewSurface::follow() {
  if (!preview_.proposal()) Q_EMIT made(nullptr);
  if (stop_) {
    *stop_ = true;
    again_ = true;
  } else if (preview_.proposal()) {
    begin();
  }
}

void PreviewSurface::begin() {
  again_ = false;
  stop_ = std::make_shared<std::atomic<bool>>(false);
  auto* watcher = new QFutureWatcher<std::shared_ptr<const Mesh>>(this);
  connect(watcher, &QFutureWatcher<std::shared_ptr<const Mesh>>::finished, this, [this, watcher] {
    watcher->deleteLater();
    const bool stopped = std::exchange(stop_, nullptr)->load();
    if (!stopped) Q_EMIT made(watcher->result());
    if (again_ && preview_.proposal()) begin();
  });
  watcher->setFuture(QtConcurrent::run([proposal = preview_.proposal(), label = preview_.label(), stop = stop_] {
    return surfaceOf(*proposal, label, *stop);
  }));
}

}  // namespace insonate::prepare
