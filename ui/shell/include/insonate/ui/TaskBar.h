#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <QFrame>
#include <QString>
#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <string>
#include <utility>

class QLabel;
class QProgressBar;
class QPushButton;
class QTimer;

namespace insonate::ui {

/// Runs one long job at a time on a thread of its own, and shows its task, its progress and a Cancel. Hidden without a
/// job.
///
/// Cancelling passes kCancelled to `done` at once and asks the job to stop; a job that is slow to notice ends in the
/// background. For the window's thread, except for the work itself.
class TaskBar : public QFrame {
  Q_OBJECT

 public:
  explicit TaskBar(QWidget* parent = nullptr);
  /// Cancels without calling `done`, and does not wait.
  ~TaskBar() override;

  /// Effect on the user of closing the window during a job.
  enum class WhenClosed {
    Stop,  ///< nothing is lost
    Ask,   ///< something that was wanted does not come about
  };

  /// `work` runs on the other thread and must not touch widgets; `done` is called on the window's thread, later. A job
  /// that is running is cancelled first. Exceptions of the work become errors.
  template <class T>
  void run(const QString& title, std::function<Result<T>(const Progress&)> work, std::function<void(Result<T>)> done,
           WhenClosed whenClosed = WhenClosed::Stop) {
    auto shared = std::make_shared<std::function<void(Result<T>)>>(std::move(done));
    start(
        title,
        [work = std::move(work), shared](const Progress& progress) -> std::function<void()> {
          auto result = std::make_shared<Result<T>>(guarded<T>(work, progress));
          return [result, shared] { (*shared)(std::move(*result)); };
        },
        [shared] { (*shared)(fail(std::string(kCancelled))); });
    whenClosed_ = whenClosed;
  }

  bool isRunning() const { return job_ != nullptr; }
  /// Tells whether closing the window now would stop something that the user waits for.
  bool asksWhenClosed() const { return job_ && whenClosed_ == WhenClosed::Ask; }
  /// Title of the running job: "Importing neck-ct".
  QString title() const;
  void cancel();

 Q_SIGNALS:
  void runningChanged(bool running);

 private:
  struct Job;
  using Deliver = std::function<void()>;

  template <class T>
  static Result<T> guarded(const std::function<Result<T>(const Progress&)>& work, const Progress& progress) {
    try {
      return work(progress);
    } catch (const std::bad_alloc&) {
      return fail("There is not enough memory. Close other programs or use a smaller volume.");
    } catch (const std::exception& e) {
      return fail(e.what());
    }
  }
  void start(const QString& title, std::function<Deliver(const Progress&)> work, Deliver cancelled);
  void look();
  void end();

  std::shared_ptr<Job> job_;
  Deliver cancelled_;
  WhenClosed whenClosed_ = WhenClosed::Stop;
  QLabel *title_, *doing_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QTimer* timer_;
};

/// Waits for the threads of all jobs, cancelled ones included, and for what cases and probes that were replaced still
/// do; false when some are still at work after `longest`. Nothing outlives main() when it is called at its end.
bool waitForJobs(std::chrono::milliseconds longest);

}  // namespace insonate::ui
