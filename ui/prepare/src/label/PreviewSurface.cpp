#include "PreviewSurface.h"

#include "LabelPreview.h"

#include <insonate/surface/ExtractSurface.h>

#include <QFutureWatcher>
#include <QtConcurrent/QtConcurrentRun>
#include <exception>
#include <string_view>
#include <utility>

namespace insonate::prepare {
namespace {

/// So that it follows a slider: a preview is looked at, not kept.
constexpr SurfaceOptions kCoarse{.smoothing_mm = 0, .detail_mm = 3};

std::shared_ptr<const Mesh> surfaceOf(const Proposal& proposal, std::uint8_t label, const std::atomic<bool>& stop) {
  try {
    auto mesh = extractSurface(proposal.labels, label, kCoarse, [&stop](std::string_view, double) { return !stop; });
    return mesh ? std::make_shared<const Mesh>(std::move(*mesh)) : nullptr;
  } catch (const std::exception&) {
    // The slices show the preview all the same.
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
