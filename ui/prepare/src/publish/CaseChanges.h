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

/// Changes of the open case that are not saved in it, as edits of a copy.
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
    LabelSession& labelling;
  };

  CaseChanges(const Sources& sources, QObject* parent);

  bool isUnsaved() const;
  /// Changes that belong to the case and are not saved in it; null without any.
  ui::CaseEdit unsavedEdit() const;
  /// Changes of visibility and opacity that are not saved in the case; null without any.
  ui::CaseEdit quietEdit() const;

 Q_SIGNALS:
  void changed();

 private:
  void refresh();

  Sources from_;
  std::array<bool, 2> has_{};  ///< unsaved, quiet
};

}  // namespace insonate::prepare
