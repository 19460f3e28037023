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

/// An attempt at a procedure, from its start to its result, recorded in the user's folder; one that is left by closing
/// the case or the program is kept as abandoned. Knows no widget. For the window's thread.
class AttemptControl : public QObject {
  Q_OBJECT

 public:
  enum class State {
    Idle,
    Starting,  ///< until the case's hash and the recording's seal are known
    Running,
    Writing,  ///< its end, off the window's thread
    Over,     ///< view() and score() are of the whole attempt
  };

  /// An empty folder is ui::attemptsFolder().
  explicit AttemptControl(TrainModel& model, QString folder = {}, QObject* parent = nullptr);
  ~AttemptControl() override;

  // Choice of the next attempt
  const std::vector<Procedure>& procedures() const { return procedures_; }
  const Procedure& procedure() const { return procedures_[chosen_]; }
  void choose(const std::string& procedure);
  /// Why none can begin on this case; empty: one can, as far as is known.
  QString unfit() const;
  /// Sets another reason why no attempt can begin, a sentence; empty for none.
  void setObstacle(const QString& why);
  Assistance assistance() const { return assistance_; }
  void setAssistance(Assistance assistance);

  State state() const { return state_; }
  bool isRunning() const { return state_ == State::Running; }
  /// Tells whether an attempt is starting, running or being written.
  bool isBusy() const { return state_ != State::Idle && state_ != State::Over; }
  void start();
  void finish() { end(AttemptStatus::Completed); }
  void abandon() { end(AttemptStatus::Abandoned); }
  /// Abandons this attempt and starts another, with the needle put away and the probe at its start.
  void startAgain();
  /// Makes a starting attempt wait for setSeal(), some seconds at most. Without a seal it begins unproven.
  void awaitSeal() { sealIsDue_ = true; }
  /// Sets the attempt's identity in a store, and the key of its nonce.
  void setSeal(const RecordedFor& whose, const std::optional<RecordKey>& key);
  /// Ends a running attempt as abandoned, because its case or the program is closed. The recording is finished on
  /// another thread, for which the destructor waits; ended() reports it, and the state is Idle then.
  void close();
  /// Changes from Over to Idle.
  void leave();

  /// Header of the attempt that began last.
  const AttemptHeader& header() const { return header_; }
  /// State of a tenth of a second ago.
  const AttemptView& view() const { return view_; }
  const AttemptScore& score() const { return score_; }
  AttemptStatus status() const { return status_; }
  /// File of the attempt that is over; empty if it could not be saved.
  QString file() const { return file_; }

  // Actions of the hands besides holding
  bool isAspirating() const { return aspirating_; }
  void setAspirating(bool on);
  /// A new needle from the tray. Refused while the old one is in the skin.
  void replaceNeedle();

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  void stateChanged();  ///< also procedure and assistance
  void starting();      ///< the time to seal its recording
  void begun();
  void ended();  ///< view(), score(), status() and file() are of the whole attempt, also where its case is gone
  void viewChanged();
  void aspiratingChanged();
  void needleReplaced();

 private:
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
  bool again_ = false;     ///< starts another once this one is written
  bool isClosed_ = false;  ///< the result of the one being written is not shown
  std::shared_future<std::string> hash_;
  AttemptView view_;
  AttemptScore score_;
  bool aspirating_ = false;
  double tilt_deg_ = 0, bloodTime_s_ = 0;
  bool settingsDue_ = false;
  QElapsedTimer sinceSettings_;
  std::string trouble_;  ///< as last said
  QTimer timer_;
};

}  // namespace insonate::train
