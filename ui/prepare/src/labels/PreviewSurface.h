#pragma once

#include <insonate/surface/Mesh.h>

#include <QObject>
#include <atomic>
#include <memory>

namespace insonate::prepare {

class LabelPreview;

/// The surface of what a preview would write, coarse, computed on another thread and following the latest.
class PreviewSurface : public QObject {
  Q_OBJECT

 public:
  PreviewSurface(LabelPreview& preview, QObject* parent);
  ~PreviewSurface() override;

 Q_SIGNALS:
  /// Announces a surface; null for none.
  void made(std::shared_ptr<const insonate::Mesh> mesh);

 private:
  void follow();
  void begin();

  LabelPreview& preview_;
  std::shared_ptr<std::atomic<bool>> stop_;  ///< of what is computed; null for nothing
  bool again_ = false;                       ///< the preview has changed meanwhile
};

}  // namespace insonate::prepare
