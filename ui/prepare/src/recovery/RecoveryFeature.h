#pragma once

#include "../feature/Feature.h"
#include "KeptWork.h"

#include <QFutureWatcher>
#include <QString>
#include <filesystem>
#include <memory>
#include <string>

namespace insonate::prepare {

class UnsavedKeeper;

/// The feature that keeps unsaved work while a case is edited, and offers it again after the program was ended by a
/// crash, a signal or a power failure.
class RecoveryFeature final : public Feature {
 public:
  RecoveryFeature(PrepareModel& model, PrepareLayout& layout);
  ~RecoveryFeature() override;

  /// Begins to keep work below this folder, and to offer the work found there.
  void keepIn(const QString& folder);

 protected:
  bool eventFilter(QObject* workspace, QEvent* event) override;

 private:
  void lookAtCase();
  void look();
  void found();
  void ask(const KeptWork& kept);
  void accept(const KeptWork& kept);
  void openCase(const KeptWork& kept);
  void openCopy(const KeptWork& kept, const Result<std::shared_ptr<const PatientCase>>& read);
  void restoreWork(const KeptWork& kept);
  void apply(const KeptWork& kept, const KeptLabels& labels);
  void giveUp(const KeptWork& kept, const Error& why);
  void discard(const KeptWork& kept);

  UnsavedKeeper& keeper_;
  std::filesystem::path root_;
  QFutureWatcher<std::shared_ptr<KeptWorkResult>> looking_;
  std::shared_ptr<const PatientCase> lookedAt_;  ///< case for which the search has begun
  bool asksOthers_ = true;                       ///< whether work on cases that are not open is offered, too
  std::filesystem::path accepted_;               ///< kept folder that the user has chosen and whose case is opened now
  std::shared_ptr<const KeptWork> copied_;       ///< the chosen work on a case that was never saved
  std::shared_ptr<const PatientCase> copy_;      ///< the copy of that case, once it was read
};

}  // namespace insonate::prepare
