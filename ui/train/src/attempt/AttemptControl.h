#pragma once

#include <insonate/curriculum/Curriculum.h>
#include <insonate/simulator/LiveAttempt.h>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QSettings;

namespace insonate::train {

struct TrainModel;

/// Runs an attempt at a procedure, from its start to its result, and records it in the user's folder. An attempt that
/// is in progress when the case or the program is closed is saved as abandoned. Uses no widgets. May be used only on
/// the window's thread.
class AttemptControl : public QObject {
  Q_OBJECT

 public:
  enum class State {
    Idle,
    Starting,  ///< waiting for the case's hash, the recording's seal and the tissue for the needle
    Running,
    Writing,  ///< the recording is finished on a background thread
    Over,     ///< the attempt has ended; view() and score() describe the whole attempt
  };

  /// `folder` receives the recordings; empty: ui::attemptsFolder().
  explicit AttemptControl(TrainModel& model, QString folder = {}, QObject* parent = nullptr);
  ~AttemptControl() override;

  // Choice of the next attempt.
  const std::vector<Procedure>& procedures() const { return procedures_; }
  const Procedure& procedure() const { return procedures_[chosen_]; }
  void choose(const std::string& procedure);
  /// Returns a sentence that says why no attempt can begin on this case; empty if no reason is known.
  QString unfit() const;
  /// Sets another reason, a sentence, why no attempt can begin; empty: no such reason.
  void setObstacle(const QString& why);
  /// Hides CT and anatomy also before the attempt begins, for a test on a case that the trainee shall not study first.
  void hideAnatomyBefore(bool on);
  Assistance assistance() const { return assistance_; }
  void setAssistance(Assistance assistance);

  State state() const { return state_; }
  bool isRunning() const { return state_ == State::Running; }
  /// Tells whether an attempt is starting, running or being written.
  bool isBusy() const { return state_ != State::Idle && state_ != State::Over; }
  void start();
  void finish() { end(AttemptStatus::Completed); }
  void abandon() { end(AttemptStatus::Abandoned); }
  /// Abandons this attempt and starts another one, with the needle put away and the probe at its start pose.
  void startAgain();
  /// Makes an attempt that is starting wait for setSeal(), at most some seconds. Without a seal, the attempt begins
  /// without proof of origin.
  void awaitSeal() { sealIsDue_ = true; }
  /// Sets the attempt's identity in a store, and the key that belongs to its nonce.
  void setSeal(const RecordedFor& whose, const std::optional<RecordKey>& key);
  /// Ends a running attempt as abandoned because its case or the program is closed. The recording is finished on a
  /// background thread, for which the destructor waits. Then ended() is emitted; the state is Idle by that time.
  void close();
  /// Changes from Over to Idle.
  void leave();

  /// Header of the attempt that began last.
  const AttemptHeader& header() const { return header_; }
  /// The attempt's state, at most a tenth of a second old.
  const AttemptView& view() const { return view_; }
  const AttemptScore& score() const { return score_; }
  AttemptStatus status() const { return status_; }
  /// Recording of the finished attempt; empty if it could not be saved.
  QString file() const { return file_; }

  // Actions of the user, except moves of probe and needle.
  bool isAspirating() const { return aspirating_; }
  void setAspirating(bool on);
  /// Performs an act of the line; an act that is not possible is refused with a message. `lumen`: see
  /// LiveAttempt::perform().
  void perform(LineAct act, int lumen = 1);
  /// Moves wire, dilator or catheter, as LiveAttempt::moveInstrument() does; a message says what held it back. Returns
  /// the distance that it has gone.
  double moveInstrument(Instrument instrument, double by_mm);
  /// LiveAttempt::wireResistance_N(); 0 without an attempt.
  double wireResistance_N() const { return isRunning() ? attempt_->wireResistance_N() : 0; }
  /// Takes a new needle from the tray. Refused while the old needle is in the skin.
  void replaceNeedle();

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  void stateChanged();  ///< emitted also when procedure() or assistance() has changed
  void starting();      ///< emitted when an attempt starts; setSeal() may now seal its recording
  void begun();
  void ended();  ///< emitted when the attempt has ended; view(), score(), status() and file() describe the whole
                 ///< attempt, even if its case is closed
  void viewChanged();
  void aspiratingChanged();
  void needleReplaced();

 private:
  void disclose();
  /// Chooses the first procedure that fits the case, if the chosen one does not: the case's targets are other vessels.
  void chooseFitting();
  void hashCase();
  void begin();
  void settingsChanged();
  void keepSettings();
  void end(AttemptStatus status);
  void write(AttemptStatus status);
  void conclude(const Result<MetricValues>& kept);
  void look();
  void show(State state);
  std::filesystem::path newFile() const;

  TrainModel& model_;
  QString folder_, file_, obstacle_;
  std::vector<Procedure> procedures_;
  std::size_t chosen_ = 0;
  Assistance assistance_ = Assistance::Guided;
  State state_ = State::Idle;
  AttemptStatus status_ = AttemptStatus::Completed;
  AttemptHeader header_;
  RecordedFor whose_;
  std::optional<RecordKey> key_;
  bool sealIsDue_ = false;
  QElapsedTimer sinceStart_;
  std::shared_ptr<LiveAttempt> attempt_;
  std::future<Result<MetricValues>> writing_;
  bool hidesBefore_ = false;  ///< hideAnatomyBefore()
  bool again_ = false;        ///< true: start another attempt when the present one has been written
  bool isClosed_ = false;     ///< true: do not show the result of the attempt that is being written
  std::shared_future<std::string> hash_;
  AttemptView view_;
  AttemptScore score_;
  bool aspirating_ = false;
  double tilt_deg_ = 0, bloodTime_s_ = 0;
  bool settingsDue_ = false;
  QElapsedTimer sinceSettings_;
  std::string error_;  ///< last error that was reported
  QTimer timer_;
};

}  // namespace insonate::train
