#pragma once

#include <insonate/surface/Mesh.h>

#include <QObject>
#include <atomic>
#include <memory>

namespace insonate::prepare {

class LabelPreview;

/// Surface of the voxels that a preview would write, at low resolution. The surface is computed on a background thread
/// and follows the latest preview.
class PreviewSurface : public QObject {
  Q_OBJECT

 public:
  PreviewSurface(LabelPreview& preview, QObject* parent);
  ~PreviewSurface() override;

 Q_SIGNALS:
  /// Emitted with the new surface; null if there is none.
  void made(std::shared_ptr<const insonate::Mesh> mesh);

 private:
  void follow();
  void begin();

  LabelPreview& preview_;
  std::shared_ptr<std::atomic<bool>> stop_;  ///< stops the running computation; null if none is running
  bool again_ = false;                       ///< true: the preview has changed during the computation
};

}  // namespace insonate::prepare
