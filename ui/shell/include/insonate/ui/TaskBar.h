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

/// Runs one long job at a time on a background thread, and shows its title, progress and a Cancel button. Hidden if no
/// job is running.
///
/// Cancelling passes kCancelled to `done` at once and asks the job to stop; a job that reacts slowly ends in the
/// background. For the window's thread, except for the work itself.
class TaskBar : public QFrame {
  Q_OBJECT

 public:
  explicit TaskBar(QWidget* parent = nullptr);
  /// Cancels without calling `done` and without waiting.
  ~TaskBar() override;

  /// Reaction when the user closes the window during a job.
  enum class WhenClosed {
    Stop,  ///< stop the job; nothing is lost
    Ask,   ///< ask first: the user would lose the job's result
  };

  /// Runs `work` on a background thread; it must not touch widgets. `done` is called later on the window's thread. A
  /// job that is already running is cancelled first. Exceptions in `work` become errors.
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

/// Waits for the threads of all jobs, including cancelled ones, and for background work of cases and probes that were
/// replaced. Returns false if some are still running after `longest`. Call it at the end of main(), so that no thread
/// outlives main().
bool waitForJobs(std::chrono::milliseconds longest);

}  // namespace insonate::ui
