#include "CaseMeasuring.h"

#include <insonate/core/ThreadPriority.h>
#include <insonate/ui/TaskBar.h>

#include <QPointer>
#include <QTimer>
#include <utility>

namespace insonate::prepare {
namespace {

using Measured = std::shared_ptr<const CaseMeasures>;

/// Share of counting in the progress; the rest is the check's.
constexpr double kCounting = 0.2;

Result<Measured> measure(const CaseView& patient, const Progress& progress) {
  const auto part = [&progress](double from, double to) -> Progress {
    return [&progress, from, to](std::string_view doing, double share) {
      return report(progress, doing, from + share * (to - from));
    };
  };
  auto statistics = caseStatistics(patient, part(0, kCounting));
  if (!statistics) return tl::unexpected(statistics.error());
  auto findings = checkCase(patient, part(kCounting, 1));
  if (!findings) return tl::unexpected(findings.error());
  return std::make_shared<const CaseMeasures>(
      CaseMeasures{std::move(*statistics), std::move(*findings), estimateDifficulty(patient)});
}

}  // namespace

CaseMeasuring::CaseMeasuring(ui::TaskBar& tasks, QObject* parent) : QObject(parent), tasks_(tasks) {
  connect(&tasks_, &ui::TaskBar::runningChanged, this, [this](bool running) {
    if (!running && state_ == State::Waiting) QTimer::singleShot(0, this, [this] { tryToRun(); });
  });
}

CaseMeasuring::~CaseMeasuring() = default;

void CaseMeasuring::setCase(std::shared_ptr<const PatientCase> patient) {
  patient_ = std::move(patient);
  labels_ = patient_ ? CaseVolumes(patient_).labels : nullptr;
  manifest_ = patient_ ? std::shared_ptr<const CaseManifest>(patient_, &patient_->manifest) : nullptr;
  measures_ = nullptr;
  edited_.reset();
  beginAgain();
}

void CaseMeasuring::setLabels(std::shared_ptr<const LabelMap> labels) {
  labels_ = std::move(labels);
  beginAgain();
}

void CaseMeasuring::awaitLabels(const LabelSet& edited) {
  const LabelSet before = std::exchange(edited_, edited_ | edited);
  if (std::exchange(labels_, nullptr)) return beginAgain();
  if (edited_ != before) Q_EMIT changed();
}

void CaseMeasuring::setWords(const CasePlaces& places, const LabelTerms& terms) {
  auto manifest = std::make_shared<CaseManifest>(*manifest_);
  putPlaces(places, *manifest);
  putTerms(terms, *manifest);
  manifest_ = std::move(manifest);
  beginAgain();
}

void CaseMeasuring::beginAgain() {
  ++number_;
  if (state_ == State::Running) tasks_.cancel();
  error_.clear();
  enter(patient_ ? State::Waiting : State::Idle);
  // The window may be in the job that opened the case.
  QTimer::singleShot(0, this, [this] { tryToRun(); });
}

void CaseMeasuring::setAllowed(bool allowed) {
  allowed_ = allowed;
  tryToRun();
}

void CaseMeasuring::start() {
  if (!patient_ || state_ == State::Running) return;
  enter(State::Waiting);
  tryToRun();
}

void CaseMeasuring::tryToRun() {
  if (state_ != State::Waiting || !labels_ || !allowed_ || tasks_.isRunning()) return;
  enter(State::Running);
  tasks_.run<Measured>(
      tr("Checking the case"),
      [patient = patient_, labels = labels_, manifest = manifest_](const Progress& progress) {
        lowerThreadPriority();
        return measure(CaseView(*manifest, patient->ct, *labels), progress);
      },
      [self = QPointer(this), number = ++number_](Result<Measured> result) {
        if (self) self->ended(number, std::move(result));
      },
      ui::TaskBar::WhenClosed::Stop, ui::TaskBar::StartedBy::Program);
}

void CaseMeasuring::ended(int number, Result<Measured> result) {
  if (number != number_) return;
  if (result) {
    measures_ = std::move(*result);
    edited_.reset();
    return enter(State::Done);
  }
  if (result.error().message != kCancelled) {
    error_ = QString::fromStdString(result.error().message);
    return enter(State::Stopped);
  }
  // The user has stopped it, or another job replaces it soon.
  enter(State::Waiting);
  QTimer::singleShot(0, this, [this, number] {
    if (number != number_ || state_ != State::Waiting || tasks_.isRunning()) return;
    error_ = tr("The check of the case was stopped.");
    enter(State::Stopped);
  });
}

void CaseMeasuring::enter(State state) {
  state_ = state;
  Q_EMIT changed();
}

}  // namespace insonate::prepare
