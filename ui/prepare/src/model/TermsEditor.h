#pragma once

#include "LabelTerms.h"

#include <QObject>
#include <QString>

class QUndoCommand;

namespace insonate::prepare {

class CaseMeasuring;
class Notice;
class OpenCase;

/// Edits the author's terms of labels: names and tissues of own labels, and the state of each label.
class TermsEditor : public QObject {
  Q_OBJECT

 public:
  TermsEditor(OpenCase& openCase, const CaseMeasuring& measuring, Notice& notice, QObject* parent);

  const LabelTerms& value() const { return terms_; }
  void set(LabelTerms terms, const QString& what);
  /// Returns the author's name of a label, else the label table's.
  QString nameOf(std::uint8_t label) const;
  LabelState stateOf(std::uint8_t label) const;
  /// Sets the name of one of the author's own labels. A name that another structure has is refused with a message.
  void setName(std::uint8_t label, const QString& name);
  void setTissue(std::uint8_t label, std::uint8_t tissue);
  void setState(std::uint8_t label, LabelState state);
  /// Adds to `all` an edit that sets these terms, if they differ from the present ones.
  void restore(const LabelTerms& terms, QUndoCommand& all);

 Q_SIGNALS:
  void ownLabelsEdited();
  void changed();

 private:
  QUndoCommand* edit(LabelTerms terms, const QString& what, QUndoCommand* parent);
  void apply(const LabelTerms& terms);

  OpenCase& openCase_;
  const CaseMeasuring& measuring_;
  Notice& notice_;
  LabelTerms terms_;
};

}  // namespace insonate::prepare
