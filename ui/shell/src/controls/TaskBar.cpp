#include "../live/JobThreads.h"

#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Theme.h>

#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <atomic>
#include <mutex>

namespace insonate::ui {
namespace {

constexpr int kLook_ms = 30;
/// Jobs that end sooner are not announced.
constexpr int kUnseen_ms = 600;
constexpr int kFine = 1000;  // of the progress bar
constexpr int kDoing_px = 180, kProgress_px = 140;

}  // namespace

struct TaskBar::Job {
  QElapsedTimer since;  ///< used by the window's thread
  std::atomic<bool> cancelled = false;
  std::mutex mutex;
  // Guarded by the mutex.
  std::string doing;
  double fraction = 0;
  Deliver deliver;  ///< called after the work
};

TaskBar::TaskBar(QWidget* parent)
    : QFrame(parent),
      title_(new QLabel),
      doing_(new QLabel),
      progress_(new QProgressBar),
      cancel_(new QPushButton(tr("Cancel"))),
      timer_(new QTimer(this)) {
  setObjectName(QStringLiteral("taskBar"));
  setRole(title_, "heading");
  setRole(doing_, "quiet");
  doing_->setFixedWidth(kDoing_px);  // texts change, but the bar does not move
  progress_->setRange(0, kFine);
  progress_->setTextVisible(false);
  progress_->setFixedWidth(kProgress_px);
  progress_->setAccessibleName(tr("Progress"));
  cancel_->setToolTip(tr("Cancels the job, which may take up to a second (Esc)"));

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kLargeGap, 2, kLargeGap, 2);
  row->setSpacing(kGap);
  row->addWidget(title_);
  row->addWidget(doing_);
  row->addWidget(progress_);
  row->addWidget(cancel_);
  timer_->setInterval(kLook_ms);
  connect(timer_, &QTimer::timeout, this, &TaskBar::look);
  connect(cancel_, &QPushButton::clicked, this, &TaskBar::cancel);
  hide();
}

TaskBar::~TaskBar() {
  if (job_) job_->cancelled = true;
}

void TaskBar::start(const QString& title, std::function<Deliver(const Progress&)> work, Deliver cancelled) {
  cancel();
  auto job = std::make_shared<Job>();
  runInBackground([job, work = std::move(work)] {
    const Progress progress = [job](std::string_view doing, double fraction) {
      const std::lock_guard lock(job->mutex);
      job->doing = doing;
      job->fraction = fraction;
      return !job->cancelled.load();
    };
    Deliver deliver = work(progress);
    const std::lock_guard lock(job->mutex);
    if (!job->cancelled) job->deliver = std::move(deliver);
  });

  job_ = std::move(job);
  cancelled_ = std::move(cancelled);
  title_->setText(title);
  doing_->clear();
  progress_->setValue(0);
  job_->since.start();
  timer_->start();
  Q_EMIT runningChanged(true);
}

void TaskBar::look() {
  Deliver deliver;
  {
    const std::lock_guard lock(job_->mutex);
    const QString doing = QString::fromStdString(job_->doing);
    doing_->setText(doing);
    // A job of a single step is named once; the sentence beside the bar uses the space.
    doing_->setVisible(doing != title_->text());
    progress_->setValue(int(job_->fraction * kFine));
    deliver = std::move(job_->deliver);
  }
  if (!deliver && isHidden() && job_->since.hasExpired(kUnseen_ms)) show();
  if (!deliver) return;
  end();
  deliver();
}

void TaskBar::cancel() {
  if (!job_) return;
  {
    const std::lock_guard lock(job_->mutex);
    job_->cancelled = true;
    job_->deliver = nullptr;
  }
  const Deliver cancelled = std::move(cancelled_);
  end();
  cancelled();
}

QString TaskBar::title() const {
  return title_->text();
}

void TaskBar::end() {
  timer_->stop();
  job_.reset();
  cancelled_ = nullptr;
  hide();
  Q_EMIT runningChanged(false);
}

}  // namespace insonate::ui
