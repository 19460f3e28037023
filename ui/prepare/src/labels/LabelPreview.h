#pragma once

#include "ProposalStore.h"

#include <insonate/core/Result.h>
#include <insonate/segmentation/LabelStep.h>

#include <QObject>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>

namespace insonate::prepare {

/// Preview of a step, computed on another thread. The latest step wins: a superseded one is stopped, and is shown only
/// if it was done already, so that the preview follows a dragged slider.
class LabelPreview : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~LabelPreview() override;

  /// CT and labels never change meanwhile.
  void want(LabelStep step, std::shared_ptr<const CtVolume> ct, std::shared_ptr<const LabelMap> labels);
  /// Shows nothing and drops running computations.
  void clear();

  /// The proposal; null for none.
  const std::shared_ptr<const Proposal>& proposal() const { return proposal_; }
  /// Label of the step; the proposal may contain others, too.
  std::uint8_t label() const { return label_; }
  /// The latest step is at work.
  bool isComputing() const { return computing_; }

 Q_SIGNALS:
  void changed();
  void computingChanged();
  /// The step cannot be done: a sentence.
  void failed(const QString& sentence);

 private:
  using Made = Result<std::shared_ptr<const Proposal>>;
  struct Wish {
    LabelStep step;
    std::shared_ptr<const CtVolume> ct;
    std::shared_ptr<const LabelMap> labels;
  };
  void begin(Wish wish);
  void setComputing(bool computing);
  void take(int number, std::uint8_t label, const Made& made);

  ProposalStore store_;
  std::shared_ptr<const Proposal> proposal_;
  std::shared_ptr<std::atomic<bool>> stop_;  ///< of what is computed; null for nothing
  std::optional<Wish> next_;
  std::uint8_t label_ = 0;
  int number_ = 0;
  bool computing_ = false;
};

}  // namespace insonate::prepare
