#pragma once

#include "attempt/AttemptDigest.h"
#include "attempt/ReplayReader.h"
#include "replay/ReplayImage.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/surface/Mesh.h>
#include <insonate/ui/CaseWorker.h>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

namespace insonate::ui {
class TaskBar;
}

namespace insonate::review {

/// Agreement between the case that is open in the window and the attempt's case.
enum class CaseFit {
  Missing,  ///< no case is open
  Other,    ///< the open case has another title; probe and needle are not shown on it
  Changed,  ///< the title agrees, but CT or labels differ from those of the attempt
  Same,
  Looking,  ///< the hash of the open case is being computed
};

/// An open recorded attempt: its events and metrics, the present time, and the patient. Uses no widgets. May be used
/// only on the window's thread.
class ReviewSession : public QObject {
  Q_OBJECT

 public:
  explicit ReviewSession(QObject* parent = nullptr);
  ~ReviewSession() override;

  /// Reads a file as a job of the task bar. The former attempt stays open until the file has been read, or if reading
  /// fails.
  void open(const QString& file, ui::TaskBar& tasks);
  void close();
  const std::shared_ptr<const AttemptDigest>& attempt() const { return attempt_; }
  bool isOpening() const { return opening_; }

  /// Sets the open case of the window.
  void setPatient(std::shared_ptr<const PatientCase> patient);
  const std::shared_ptr<const PatientCase>& patient() const { return patient_; }
  CaseFit fit() const { return fit_; }
  /// Tells whether probe and needle are shown on the patient.
  bool fits() const { return fit_ == CaseFit::Same || fit_ == CaseFit::Changed; }
  /// Sets whether the workspace is visible. While the workspace is not visible, nothing is computed.
  void setAwake(bool awake);

  /// Present time, from 0 to the attempt's end. Setting the time never waits: if the time is set many times in quick
  /// succession, the image of the latest time is computed.
  std::int64_t time_us() const { return time_us_; }
  void setTime(std::int64_t time_us);
  void step(double seconds) { setTime(time_us_ + std::int64_t(seconds * 1e6)); }
  /// Moves to the next or previous moment; no effect if there is none.
  void stepMoment(int by);
  /// State of probe and needle at the present time; empty in a damaged part of the recording.
  const std::optional<AttemptSample>& sample() const { return sample_; }
  /// Place of the needle's tip at the present time.
  AttemptDigest::PlaceChange needle() const;

  bool isPlaying() const { return timer_.isActive(); }
  void setPlaying(bool playing);
  static constexpr double kSpeeds[] = {0.25, 0.5, 1, 2, 4};
  double speed() const { return speed_; }
  /// Sets the speed to one of kSpeeds.
  void setSpeed(double speed);

  ReplayImage& picture() { return picture_; }
  /// Tells whether the image on display belongs to another time of the attempt, or to another position of the probe.
  bool isImageStale() const;
  const ReplayReader* reader() const { return reader_ ? &*reader_ : nullptr; }
  bool surfacesThere() const { return !surfaces_ || surfacesDone_; }
  /// Tells whether the image of the present time is ready, or whether there will be no image.
  bool isSettled() const;
  QString message() const;

  void stop();

 Q_SIGNALS:
  void attemptChanged();
  void caseChanged();  ///< emitted when patient() or fit() has changed
  void timeChanged();
  void playingChanged();
  void pictureShown();
  void messageChanged();
  void surfaceMade(int label, const std::shared_ptr<const insonate::Mesh>& mesh);
  void surfacesDone();
  void openingChanged();
  void failed(const QString& what, const QString& advice);

 private:
  void take(std::shared_ptr<const AttemptDigest> attempt);
  void match();
  void hashed(const std::shared_ptr<const PatientCase>& patient, const QString& hash);
  void startPatient();
  void tick();
  void show();

  std::shared_ptr<const AttemptDigest> attempt_;
  std::optional<ReplayReader> reader_;
  std::shared_ptr<const PatientCase> patient_, shownPatient_;
  QString hash_;  ///< hash of patient_; empty: not computed yet
  CaseFit fit_ = CaseFit::Missing;
  std::unique_ptr<ui::CaseWorker> surfaces_;
  bool surfacesDone_ = false, awake_ = false, opening_ = false;
  int round_ = 0;  ///< number of the last opening or closing; results of earlier openings are dropped
  ReplayImage picture_;
  std::int64_t time_us_ = 0;
  std::optional<AttemptSample> sample_;
  QTimer timer_;
  QElapsedTimer clock_;
  double speed_ = 1;
};

}  // namespace insonate::review
