#pragma once

#include "KeptFolder.h"

#include <insonate/cases/UnsavedWork.h>

#include <QElapsedTimer>
#include <QFutureWatcher>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>

namespace insonate::prepare {

struct PrepareModel;

/// Keeps the unsaved work on the open case in a folder of the user, so that the work survives the end of the program.
/// Kept is all that the window would ask about before it closes, some seconds after each edit. The window's thread only
/// collects values and a snapshot of the labels; a thread of low priority compares the labels and writes the files.
class UnsavedKeeper : public QObject {
  Q_OBJECT

 public:
  UnsavedKeeper(PrepareModel& model, QObject* parent);
  /// Deletes the kept work: a window that closes has asked the user before.
  ~UnsavedKeeper() override;

  /// Begins to keep work in folders below `root`.
  void keepIn(const std::filesystem::path& root);
  /// Continues with a folder whose work was restored into the open case. `isSameCase`: the case is the one to which
  /// the checksums of the work belong.
  void adopt(std::shared_ptr<KeptFolder> folder, const UnsavedWork& work, bool isSameCase);
  /// Thread of low priority that reads and writes kept work, one job after the other.
  QThreadPool& thread() { return thread_; }

  /// Time from the last edit to writing, and the longest time from the first edit that is not written.
  static constexpr int kAfterEdit_ms = 2000, kLongest_ms = 10'000;

 Q_SIGNALS:
  void kept();
  void failed(const QString& sentence);

 private:
  /// Kept work on one case; after its construction used only by jobs of the thread.
  struct Kept {
    std::shared_ptr<KeptFolder> folder;
    std::shared_ptr<const PatientCase> base;  ///< case to which `sums` belong
    CaseSums sums;
    bool isCopied = false;  ///< whether the base is copied into the folder
    std::atomic<bool> isOver{false};
  };
  struct Job;

  bool isAtStake() const;
  void begin();
  void refresh();
  void keep();
  void ended();
  void forget();
  static Result<void> write(const Job& job, std::shared_ptr<const LabelMap> labels);

  PrepareModel& model_;
  std::filesystem::path root_;
  QString caseFolder_;
  std::shared_ptr<Kept> kept_ = std::make_shared<Kept>();
  bool isKept_ = false;  ///< whether a folder may exist
  QTimer due_;
  std::optional<QElapsedTimer> waiting_;  ///< time since the first edit that is not written
  QThreadPool thread_;
  QFutureWatcher<Result<void>> writing_;
  bool hasFailed_ = false;
};

}  // namespace insonate::prepare
