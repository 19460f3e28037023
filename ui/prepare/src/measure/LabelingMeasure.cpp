#include "LabelingMeasure.h"

#include "../labels/LabelSession.h"
#include "../layout/CaseViews.h"
#include "../model/Crosshair.h"
#include "../model/LivePatient.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"
#include "../model/StructureList.h"
#include "../tools/ToolSession.h"

#include <insonate/core/ProcessorTime.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/ViewWidget.h>

#include <algorithm>
#include <utility>

namespace insonate::prepare {
namespace {

constexpr int kTick_ms = 1;
constexpr int kDragged = 4;  // times as many moves as other actions
/// Timeout after which a missing result counts with this duration.
constexpr double kPatience_ms = 180'000;
constexpr double kRegion_mm = 30;  // distance from a click to the edge of the region for growing and level set
constexpr HuRange kBlood{120, 240};

double ms(const QElapsedTimer& clock) {
  return double(clock.nsecsElapsed()) / 1e6;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Vec3 placeIn(const PatientCase& patient) {
  const auto& targets = patient.manifest.targets;
  return targets.empty() ? patient.ct.geometry.center_mm() : targets.front().position_mm;
}

}  // namespace

LabelingMeasure::LabelingMeasure(PrepareModel& shared, ToolSession& tools, CaseViews& views, int repeats,
                                 std::function<void(std::vector<LabelingTime>)> done)
    : shared_(shared), tools_(tools), views_(views), done_(std::move(done)) {
  addViewTasks(repeats);
  addToolTasks(repeats);
  connect(&shared_.labeling.preview(), &LabelPreview::changed, this, [this] {
    if (!acting_ || !shared_.labeling.preview().proposal()) return;
    remember();
    slicesKnow_ = true;
  });
  connect(&views_.previewSurface(), &PreviewSurface::made, this, [this] {
    if (!acting_ || !slicesKnow_) return;
    renderings_.back() = views_.widgets().back()->renderings();
    sceneKnows_ = true;
  });
  connect(&timer_, &QTimer::timeout, this, [this] { look(); });
  timer_.setTimerType(Qt::PreciseTimer);
  clock_.start();
  tick_.start();
  timer_.start(kTick_ms);
}

void LabelingMeasure::addViewTasks(int repeats) {
  const Vec3 middle_mm = placeIn(*shared_.openCase.patient());
  const Vec3 step_mm = shared_.openCase.patient()->ct.geometry.spacing_mm;
  const auto painted = [this] { return slicesPainted(); };
  const auto along = [=](int n) { return middle_mm + Vec3{n * step_mm.x, n * step_mm.y, n * step_mm.z}; };
  tasks_.push_back({repeats,
                    {},
                    [this, along](int n) {
                      slicesKnow_ = true;
                      shared_.crosshair.moveTo(along(n + 1));
                    },
                    {{QStringLiteral("slice_change"), painted},
                     {QStringLiteral("ultrasound_follows"), [this] { return shared_.live.isSettled(); }}}});
  // Without pauses: each move as soon as the one before has been painted.
  tasks_.push_back({kDragged * repeats,
                    {},
                    [this, along](int n) {
                      slicesKnow_ = true;
                      shared_.crosshair.moveTo(along(-(n + 1)));
                    },
                    {{QStringLiteral("slice_drag"), painted}},
                    {},
                    0});
  tasks_.push_back({repeats,
                    [this, middle_mm] {
                      shared_.crosshair.moveTo(middle_mm);
                      shared_.structures.add(kArtery);
                      tools_.choose(QStringLiteral("paint"));
                    },
                    [this, along](int n) {
                      slicesKnow_ = true;
                      n == 0 ? void(tools_.beginStroke(along(0), views::SliceKind::Axial)) : tools_.strokeTo(along(n));
                    },
                    {{QStringLiteral("brush_stroke"), painted}}});
  tasks_.push_back({repeats,
                    [this] {
                      tools_.endStroke();
                      tools_.choose(QStringLiteral("threshold"));
                    },
                    [this](int n) {
                      tools_.setRange({kBlood.low + 5 * (n % 8), 3000});
                    },
                    {{QStringLiteral("threshold_slices"), painted},
                     {QStringLiteral("threshold_with_3d"), [this] { return slicesPainted() && scenePainted(); }}}});
}

void LabelingMeasure::addToolTasks(int repeats) {
  const Vec3 middle_mm = placeIn(*shared_.openCase.patient());
  LabelStep grow;
  grow.tool = step::Connected{{middle_mm}, kBlood};
  grow.label = kVein;
  const Vec3 reach_mm{kRegion_mm, kRegion_mm, kRegion_mm};
  grow.box_mm = std::array{middle_mm - reach_mm, middle_mm + reach_mm};
  LabelStep contour = grow;
  contour.tool = step::Contour{};
  LabelStep automatic;
  automatic.tool = step::Auto{};
  tasks_.push_back(tool(QStringLiteral("growing_on_region"), grow, std::min(repeats, 3)));
  tasks_.push_back(tool(QStringLiteral("level_set_on_region"), contour, std::min(repeats, 3)));
  tasks_.push_back(tool(QStringLiteral("automatic_part"), automatic, 1));
}

LabelingMeasure::Task LabelingMeasure::tool(const QString& name, const LabelStep& step, int repeats) {
  const auto run = [this, step, name](int) {
    shared_.labeling.run(step, name, [this](const Result<LabelChange>&) {
      remember();
      slicesKnow_ = true;
    });
  };
  const auto undo = [this] { shared_.openCase.undoStack().undo(); };
  return {repeats, [this] { tools_.choose({}); }, run, {{name, [this] { return slicesPainted(); }}}, undo};
}

void LabelingMeasure::remember() {
  for (std::size_t view = 0; view < renderings_.size(); ++view)
    renderings_[view] = views_.widgets()[view]->renderings();
}

bool LabelingMeasure::slicesPainted() const {
  if (!slicesKnow_) return false;
  for (std::size_t view = 0; view < CaseViews::kSlices; ++view)
    if (views_.widgets()[view]->renderings() <= renderings_[view]) return false;
  return true;
}

bool LabelingMeasure::scenePainted() const {
  const ui::ViewWidget& scene = *views_.widgets().back();
  return sceneKnows_ && scene.renderings() > renderings_.back() && !scene.isDrawing();
}

/// Frames rendered before a tick of the timer have been painted by then.
void LabelingMeasure::look() {
  const double since_ms = ms(tick_), before_ms = std::exchange(tickWork_ms_, threadTime_ms());
  tick_.start();
  if (task_ == tasks_.size()) {
    timer_.stop();
    if (const auto done = std::exchange(done_, nullptr)) done(times_);
    return;
  }
  Task& task = tasks_[task_];
  if (!acting_) {
    const LabelSession& labeling = shared_.labeling;
    if (ms(clock_) >= task.rest_ms && !labeling.isBusy() && !labeling.preview().isComputing()) begin();
    return;
  }
  task.pause_ms = std::max(task.pause_ms, since_ms);
  task.work_ms = std::max(task.work_ms, tickWork_ms_ - before_ms);
  const auto missing = [&](const Sight& sight) { return int(sight.took_ms.size()) <= repeat_; };
  for (Sight& sight : task.sights)
    if (missing(sight) && (sight.there() || ms(clock_) > kPatience_ms)) sight.took_ms.push_back(ms(clock_));
  if (std::ranges::any_of(task.sights, missing)) return;
  acting_ = false;
  if (task.putBack) task.putBack();
  if (++repeat_ == task.repeats) endTask();
  clock_.start();
}

void LabelingMeasure::begin() {
  Task& task = tasks_[task_];
  if (repeat_ == 0)
    if (const auto takeUp = std::exchange(task.takeUp, nullptr)) {
      takeUp();
      clock_.start();
      return;
    }
  slicesKnow_ = sceneKnows_ = false;
  remember();
  acting_ = true;
  clock_.start();
  task.act(repeat_);
}

void LabelingMeasure::endTask() {
  const Task& task = tasks_[task_++];
  repeat_ = 0;
  for (const Sight& sight : task.sights)
    times_.push_back(
        {sight.name, median(sight.took_ms), *std::ranges::max_element(sight.took_ms), task.pause_ms, task.work_ms});
}

}  // namespace insonate::prepare
