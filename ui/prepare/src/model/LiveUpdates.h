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

/// Updates surfaces and the live image when the open case, its own labels or the visible structures change.
class LiveUpdates : public QObject {
 public:
  LiveUpdates(OpenCase& openCase, const StructureAppearance& appearance, const TermsEditor& terms,
              LabelSession& labeling, LivePatient& live, QObject* parent);

  /// Returns the surfaces to compute again after edits of `labels`.
  std::vector<ui::SurfaceRequest> changedSurfaces(const LabelSet& labels) const;

 private:
  std::vector<ui::SurfaceRequest> missingSurfaces();

  const StructureAppearance& appearance_;
  std::array<bool, 256> wanted_{};  ///< surfaces that have been requested
};

}  // namespace insonate::prepare
