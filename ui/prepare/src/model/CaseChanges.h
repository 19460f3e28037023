#pragma once

#include <insonate/ui/Workspace.h>

#include <QObject>
#include <array>

namespace insonate::prepare {

class LabelSession;
class OpenCase;
class PlacesEditor;
class StructureAppearance;
class StructureList;
class TermsEditor;

/// Unsaved changes of the open case, as edits that can be applied to a copy.
class CaseChanges : public QObject {
  Q_OBJECT

 public:
  /// Parts of the model that are saved with the case.
  struct Sources {
    const OpenCase& openCase;
    const StructureList& structures;
    const StructureAppearance& appearance;
    const TermsEditor& terms;
    const PlacesEditor& places;
    LabelSession& labeling;
  };

  CaseChanges(const Sources& sources, QObject* parent);

  bool isUnsaved() const;
  /// Returns the unsaved changes that belong to the case; null if there are none.
  ui::CaseEdit unsavedEdit() const;
  /// Returns the unsaved changes of visibility and opacity; null if there are none.
  ui::CaseEdit unpromptedEdit() const;
  /// Writes all values of the case except its labels into a copy of its manifest and colors.
  void putValues(CaseManifest& manifest, LabelColors& colors) const;

 Q_SIGNALS:
  void edited();   ///< emitted after each edit and after saving
  void changed();  ///< emitted when an edit becomes null or ceases to be null

 private:
  void refresh();

  Sources from_;
  std::array<bool, 2> has_{};  ///< whether there are unsaved and quiet edits
};

}  // namespace insonate::prepare
