#pragma once

#include "../check/CasePlaces.h"
#include "../table/LabelTerms.h"
#include "Structures.h"

#include <insonate/cases/PatientCase.h>

#include <QString>
#include <QUndoCommand>
#include <chrono>

namespace insonate::prepare {

class PrepareSession;

/// A change of how one structure is drawn. Changes of opacity that follow each other closely are one.
class LookEdit : public QUndoCommand {
 public:
  LookEdit(PrepareSession& session, std::uint8_t label, const StructureLook& after, const QString& what,
           QUndoCommand* parent = nullptr);
  void undo() override;
  void redo() override;
  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override;

 private:
  PrepareSession& session_;
  std::uint8_t label_;
  StructureLook before_, after_;
  std::chrono::steady_clock::time_point when_ = std::chrono::steady_clock::now();
};

/// Another title of the case.
class TitleEdit : public QUndoCommand {
 public:
  TitleEdit(PrepareSession& session, const QString& after, QUndoCommand* parent = nullptr);
  void undo() override;
  void redo() override;

 private:
  PrepareSession& session_;
  QString before_, after_;
};

/// Other targets, landmarks, start poses, or another grade.
class PlacesEdit : public QUndoCommand {
 public:
  PlacesEdit(PrepareSession& session, CasePlaces after, const QString& what, QUndoCommand* parent = nullptr);
  void undo() override;
  void redo() override;

 private:
  PrepareSession& session_;
  CasePlaces before_, after_;
};

/// Other words of the author about labels.
class TermsEdit : public QUndoCommand {
 public:
  TermsEdit(PrepareSession& session, LabelTerms after, const QString& what, QUndoCommand* parent = nullptr);
  void undo() override;
  void redo() override;

 private:
  PrepareSession& session_;
  LabelTerms before_, after_;
};

}  // namespace insonate::prepare
