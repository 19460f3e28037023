#include "LevelControl.h"

#include "../attempt/AttemptControl.h"
#include "../model/CaseModel.h"
#include "../model/ImagingModel.h"
#include "../model/ProbeMotion.h"
#include "../model/StatusLine.h"
#include "Course.h"

#include <insonate/simulator/AttemptStart.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/Text.h>

#include <QFileInfo>
#include <algorithm>
#include <utility>

namespace insonate::train {
LevelControl::LevelControl(StatusLine& status, CaseModel& patientCase, ImagingModel& imaging, ProbeMotion& motion,
                           AttemptControl& attempt, Course& course, QObject* parent)
    : QObject(parent),
      status_(status),
      patientCase_(patientCase),
      imaging_(imaging),
      motion_(motion),
      attempt_(attempt),
      course_(course) {
  connect(&patientCase_, &CaseModel::caseChanged, this, [this] { caseChanged(); });
  connect(&course_, &Course::changed, this, [this] { courseChanged(); });
  connect(&course_, &Course::casesDownloaded, this, [this] { openArrivedCase(); });
  connect(&attempt_, &AttemptControl::stateChanged, this, [this] {
    if (attempt_.state() == AttemptControl::State::Starting) {
      arrange();
      beginWithoutStore();
    } else if (!attempt_.isBusy()) {
      motion_.releaseStart();
    }
  });
}

bool LevelControl::fits() const {
  const auto& patient = patientCase_.patient();
  if (!patient) return false;
  const QString title = ui::qt(patient->manifest.title);
  if (title != ui::builtInTitle(ui::qt(level_->caseName))) return false;
  // An author's draft may have the same title: a level is practiced on the published version.
  const auto place = ui::findCaseLocation(ui::qt(level_->caseName));
  if (!place) return true;
  const ui::CaseOrigin& origin = patientCase_.origin();
  if (ui::builtInCaseNames().contains(*place)) return origin.builtIn;
  return QFileInfo(origin.readFrom) == QFileInfo(ui::trainingLocation(*place));
}

AttemptAim LevelControl::aim() const {
  if (!level_ || !course_.curriculum()) return {};
  return {course_.curriculum(), course_.curriculum()->level(level_->name)};
}

void LevelControl::choose(const std::string& name) {
  const Level* level = course_.curriculum() ? course_.curriculum()->level(name) : nullptr;
  const LevelProgress* progress = course_.progressIn(name);
  if (!level || !progress) return;
  if (progress->state == LevelState::Locked) return status_.showMessage(ui::qt(progress->why));
  if (attempt_.isBusy()) return status_.showMessage(tr("First finish or abandon the attempt in progress."));
  attempt_.leave();
  level_ = *level;
  arrange();
  Q_EMIT changed();
  if (waitsForCase()) openCase();
}

void LevelControl::openCase() {
  if (!level_) return;
  if (const auto place = ui::findCaseLocation(ui::qt(level_->caseName)))
    return Q_EMIT caseRequested(ui::trainingLocation(*place));
  const QString title = ui::qt(level_->caseName);
  status_.showMessage(
      ui::isBeingDownloaded(title)
          ? tr("The case '%1' of this level is being downloaded from the server. It opens when it is complete.")
                .arg(title)
          : tr("The case '%1' of this level is not on this computer. Open the case once (Ctrl+O), so that the "
               "program finds it.")
                .arg(title));
}

/// The level's case, or a new version of it, may have arrived. An attempt in progress goes on.
void LevelControl::openArrivedCase() {
  if (!level_ || !waitsForCase() || attempt_.isBusy() || !ui::findCaseLocation(ui::qt(level_->caseName))) return;
  arrange();
  Q_EMIT changed();
  openCase();
}

void LevelControl::leave() {
  if (!std::exchange(level_, std::nullopt)) return;
  attempt_.setObstacle({});
  attempt_.hideAnatomyBefore(false);
  Q_EMIT changed();
}

void LevelControl::caseChanged() {
  if (!level_ || !patientCase_.patient()) return;
  if (!fits()) {
    status_.showMessage(tr("The level '%1' needs another case. With the present case, attempts are free practice.")
                            .arg(ui::qt(level_->title)));
    return leave();
  }
  arrange();
  Q_EMIT changed();
}

/// Another user, or another curriculum.
void LevelControl::courseChanged() {
  if (!level_) return;
  const Level* now = course_.curriculum() ? course_.curriculum()->level(level_->name) : nullptr;
  if (!now || *now != *level_) leave();
}

/// Procedure, assistance and position are the level's.
void LevelControl::arrange() {
  if (!level_) return;
  attempt_.choose(level_->procedure);
  attempt_.setAssistance(level_->assistance);
  attempt_.hideAnatomyBefore(level_->assistance == Assistance::Test);
  attempt_.setObstacle(waitsForCase()
                           ? tr("This level needs the case '%1'.").arg(ui::builtInTitle(ui::qt(level_->caseName)))
                           : QString());
  const auto& positions = attempt_.procedure().positions;
  const auto position = std::ranges::find(positions, level_->position, &PatientPosition::name);
  if (position != positions.end() && !waitsForCase() && imaging_.tissue().body.tilt_deg != position->tilt_deg)
    imaging_.setTilt(position->tilt_deg);
}

/// On the vein, a level would ask for no more than to push the needle in.
void LevelControl::beginWithoutStore() {
  const auto home = level_ ? motion_.handAtStart() : std::nullopt;
  if (!home) return;
  const VesselLocator vessels(patientCase_.patient()->manifest, attempt_.procedure(), home->pose().offset);
  std::uniform_int_distribution<int> any(0, kAttemptStarts - (place_ < 0 ? 1 : 2));
  const int drawn = any(random_);
  place_ = place_ >= 0 && drawn >= place_ ? drawn + 1 : drawn;
  motion_.beginAt(attemptStart(*home, vessels, {}, place_, random_()));
}

}  // namespace insonate::train
