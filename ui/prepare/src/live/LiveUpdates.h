#pragma once

#include <insonate/segmentation/LabelEdit.h>
#include <insonate/ui/CaseWorker.h>

#include <QObject>
#include <array>
#include <vector>

namespace insonate::prepare {

class LabelSession;
class LivePatient;
class OpenCase;
class StructureAppearance;
class TermsEditor;

/// Keeps surfaces and the live image at the open case: its voxels, its own labels, and the structures that are visible.
class LiveUpdates : public QObject {
 public:
  LiveUpdates(OpenCase& openCase, const StructureAppearance& appearance, const TermsEditor& terms,
              LabelSession& labelling, LivePatient& live, QObject* parent);

  /// Surfaces to be made again after edits of `labels`.
  std::vector<ui::SurfaceWish> changedSurfaces(const LabelSet& labels) const;

 private:
  std::vector<ui::SurfaceWish> missingSurfaces();

  const StructureAppearance& appearance_;
  std::array<bool, 256> wanted_{};  ///< surfaces that have been requested
};

}  // namespace insonate::prepare
