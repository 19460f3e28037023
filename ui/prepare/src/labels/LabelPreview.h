#pragma once

#include <insonate/core/Result.h>
#include <insonate/segmentation/LabelStep.h>
#include <insonate/segmentation/Region.h>

#include <QObject>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>

namespace insonate::prepare {

/// Preview of a labeling step, computed on a background thread. A new step stops the computation of an earlier step. A
/// result that was finished before that is still shown, so that the preview follows a dragged slider.
class LabelPreview : public QObject {
  Q_OBJECT

 public:
  explicit LabelPreview(QObject* parent);
  ~LabelPreview() override;

  /// Requests the preview of a step. CT and labels must not change during the computation.
  void want(LabelStep step, std::shared_ptr<const CtVolume> ct, std::shared_ptr<const LabelMap> labels);
  /// Removes the preview and stops running computations.
  void clear();

  /// The computed proposal; null if there is none.
  const std::shared_ptr<const Proposal>& proposal() const { return proposal_; }
  /// Label of the step. The proposal may contain other labels, too.
  std::uint8_t label() const { return label_; }
  /// Tells whether the latest step is being computed.
  bool isComputing() const { return computing_; }

 Q_SIGNALS:
  void changed();
  void computingChanged();
  /// Emitted with a sentence if the step cannot be performed.
  void failed(const QString& sentence);

 private:
  struct Buffers;
  using Made = Result<std::shared_ptr<const Proposal>>;
  struct Wish {
    LabelStep step;
    std::shared_ptr<const CtVolume> ct;
    std::shared_ptr<const LabelMap> labels;
  };
  void begin(Wish wish);
  void setComputing(bool computing);
  /// Returns a proposal to be filled; the proposal still has former contents.
  std::shared_ptr<Proposal> takeBuffer();
  void take(int number, std::uint8_t label, const Made& made);

  std::shared_ptr<Buffers> buffers_;
  std::shared_ptr<const Proposal> proposal_;
  std::shared_ptr<std::atomic<bool>> stop_;  ///< stops the running computation; null if none is running
  std::optional<Wish> next_;
  std::uint8_t label_ = 0;
  int number_ = 0;
  bool computing_ = false;
};

}  // namespace insonate::prepare
