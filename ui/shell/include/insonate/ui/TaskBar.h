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

/// A bar that runs one long job at a time on a background thread, and shows the title of the job, its progress and a
/// Cancel button. The bar is hidden if no job is running.
///
/// Cancel passes kCancelled to `done` at once and asks the job to stop; a job that reacts slowly ends in the
/// background. All functions are for the window's thread only.
class TaskBar : public QFrame {
  Q_OBJECT

 public:
  explicit TaskBar(QWidget* parent = nullptr);
  /// Cancels the job, without calling `done` and without waiting.
  ~TaskBar() override;

  /// Action when the user closes the window while a job is running.
  enum class WhenClosed {
    Stop,  ///< stop the job; nothing is lost
    Ask,   ///< ask first: the user would lose the job's result
  };

  /// Origin of a job.
  enum class StartedBy {
    User,
    Program,  ///< the program, which starts the job again if another job replaces it; neither Esc nor saving waits for
              ///< it
  };

  /// Runs `work` on a background thread; `work` must not use widgets. When `work` has ended, `done` is called on the
  /// window's thread. A job that is already running is cancelled first. Exceptions of `work` become errors.
  template <class T>
  void run(const QString& title, std::function<Result<T>(const Progress&)> work, std::function<void(Result<T>)> done,
           WhenClosed whenClosed = WhenClosed::Stop, StartedBy startedBy = StartedBy::User) {
    cancel();
    // Set before runningChanged(), whose receivers ask who waits for the job.
    whenClosed_ = whenClosed, startedBy_ = startedBy;
    auto shared = std::make_shared<std::function<void(Result<T>)>>(std::move(done));
    start(
        title,
        [work = std::move(work), shared](const Progress& progress) -> std::function<void()> {
          auto result = std::make_shared<Result<T>>(guarded<T>(work, progress));
          return [result, shared] { (*shared)(std::move(*result)); };
        },
        [shared] { (*shared)(fail(std::string(kCancelled))); });
  }

  bool isRunning() const { return job_ != nullptr; }
  /// Tells whether a job that the user has started is running.
  bool isUserWaiting() const { return job_ && startedBy_ == StartedBy::User; }
  /// Tells whether a job is running whose result would be lost if the window were closed now (WhenClosed::Ask).
  bool asksWhenClosed() const { return job_ && whenClosed_ == WhenClosed::Ask; }
  /// Returns the title of the running job, e.g. "Importing neck-ct".
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
  StartedBy startedBy_ = StartedBy::User;
  QLabel *title_, *doing_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QTimer* timer_;
};

/// Waits for the threads of all jobs, including cancelled ones, and for background threads of cases and probes that
/// were replaced. Returns false if a thread is still running after the time `longest`. Call it at the end of main(), so
/// that no thread outlives main().
bool waitForJobs(std::chrono::milliseconds longest);

}  // namespace insonate::ui
