#pragma once

#include "attempt/AttemptDigest.h"
#include "attempt/ReplayReader.h"
#include "replay/ReplayPicture.h"

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

/// Agreement of the case in the window with the attempt's.
enum class CaseFit {
  Missing,  ///< none is open
  Other,    ///< of another title: hands are not shown on it
  Changed,  ///< the title is right, CT or labels are not those of the attempt
  Same,
  Looking,  ///< its hash is being computed
};

/// An open recorded attempt, without a widget: its events and metrics, the present time, and the patient. For the
/// window's thread.
class ReviewSession : public QObject {
  Q_OBJECT

 public:
  explicit ReviewSession(QObject* parent = nullptr);
  ~ReviewSession() override;

  /// Reads the file in the task bar's job. The former attempt stays until then, and if reading fails.
  void open(const QString& file, ui::TaskBar& tasks);
  void close();
  const std::shared_ptr<const AttemptDigest>& attempt() const { return attempt_; }
  bool isOpening() const { return opening_; }

  /// The case of the window.
  void setPatient(std::shared_ptr<const PatientCase> patient);
  const std::shared_ptr<const PatientCase>& patient() const { return patient_; }
  CaseFit fit() const { return fit_; }
  /// Tells whether hands are shown on the patient.
  bool fits() const { return fit_ == CaseFit::Same || fit_ == CaseFit::Changed; }
  /// While the workspace is hidden, nothing is computed.
  void setAwake(bool awake);

  /// Present time, 0 to the attempt's end. Setting it never waits: of many times in a row, images show the latest.
  std::int64_t time_us() const { return time_us_; }
  void setTime(std::int64_t time_us);
  void step(double seconds) { setTime(time_us_ + std::int64_t(seconds * 1e6)); }
  /// Moves to the next or previous moment; no effect without one.
  void stepMoment(int by);
  /// State of the hands at that time; none in a damaged stretch.
  const std::optional<AttemptSample>& sample() const { return sample_; }
  /// Place of the needle's tip at that time.
  AttemptDigest::PlaceChange needle() const;

  bool isPlaying() const { return timer_.isActive(); }
  void setPlaying(bool playing);
  static constexpr double kSpeeds[] = {0.25, 0.5, 1, 2, 4};
  double speed() const { return speed_; }
  /// One of kSpeeds.
  void setSpeed(double speed);

  ReplayPicture& picture() { return picture_; }
  const ReplayReader* reader() const { return reader_ ? &*reader_ : nullptr; }
  bool surfacesThere() const { return !surfaces_ || surfacesDone_; }
  /// Tells whether the image of the present time is ready, or there is none.
  bool isSettled() const;
  QString message() const;

  void stop();

 Q_SIGNALS:
  void attemptChanged();
  void caseChanged();  ///< patient() or fit()
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
  QString hash_;  ///< of patient_; empty: not known yet
  CaseFit fit_ = CaseFit::Missing;
  std::unique_ptr<ui::CaseWorker> surfaces_;
  bool surfacesDone_ = false, awake_ = false, opening_ = false;
  ReplayPicture picture_;
  std::int64_t time_us_ = 0;
  std::optional<AttemptSample> sample_;
  QTimer timer_;
  QElapsedTimer clock_;
  double speed_ = 1;
};

}  // namespace insonate::review
