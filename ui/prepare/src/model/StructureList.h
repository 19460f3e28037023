#pragma once

#include <insonate/segmentation/LabelEdit.h>

#include <QObject>
#include <cstdint>
#include <vector>

namespace insonate::prepare {

class CaseMeasuring;
class LabelSession;
class Notice;
class OpenCase;
class TermsEditor;

/// The list of structures in the table, and the selected structure.
class StructureList : public QObject {
  Q_OBJECT

 public:
  StructureList(OpenCase& openCase, const CaseMeasuring& measuring, LabelSession& labeling, TermsEditor& terms,
                Notice& notice, QObject* parent);

  /// Labels of the structures that have voxels or were added, in the table's order; empty until the voxels are counted.
  const std::vector<std::uint8_t>& labels() const { return labels_; }
  std::uint8_t selected() const { return selected_; }
  void select(std::uint8_t label);
  /// Selects the next or previous structure of the table.
  void selectNext(int step);
  /// Adds a structure without voxels to the list and selects the structure. The user can undo this for one of the
  /// author's own structures.
  void add(std::uint8_t label);
  /// Changes all voxels of a structure to soft tissue (voxels of soft tissue to background). If one of the author's own
  /// structures has no voxels, removes the structure.
  void removeVoxels(std::uint8_t label);
  /// Moves a listed structure to its next state, and shows a message.
  void toNextState(std::uint8_t label);

 Q_SIGNALS:
  void changed();
  void selectedChanged();

 private:
  void refresh();
  bool isListed(std::uint8_t label) const;

  OpenCase& openCase_;
  const CaseMeasuring& measuring_;
  LabelSession& labeling_;
  TermsEditor& terms_;
  Notice& notice_;
  std::vector<std::uint8_t> labels_;
  LabelSet added_;  ///< labels that were added and whose voxels are not counted yet
  std::uint8_t selected_ = 0;
};

}  // namespace insonate::prepare
