#include "ui/keys/pairing_question_form.h"

#include "ui/keys/fingerprint_text.h"
#include "ui/theme/grid.h"

#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>

namespace skyseal::ui {

namespace {

constexpr double kCodeScale = 2.5; ///< of the code's letters, which are read aloud

} // namespace

PairingQuestionForm::PairingQuestionForm(const channel::PublicKey &ownKey, QWidget *parent) : QWidget(parent)
{
    m_code = fixedWidthLabel({}, "pairingCode", tr("Code"), this);
    QFont large = m_code->font();
    large.setPointSizeF(large.pointSizeF() * kCodeScale);
    large.setBold(true);
    m_code->setFont(large);
    m_code->setAlignment(Qt::AlignCenter);
    m_name = new QLineEdit(this);
    m_name->setObjectName(QStringLiteral("pairingName"));
    m_name->setAccessibleName(tr("Name"));
    m_system = new QLabel(this);
    m_system->setObjectName(QStringLiteral("pairingSystem"));
    m_ours = fixedWidthLabel(fingerprintLines(ownKey), "pairingOwn", tr("Fingerprint of this station"), this);
    m_theirs = fixedWidthLabel({}, "pairingTheirs", tr("Fingerprint of the agent"), this);

    m_form = new QFormLayout;
    m_form->setHorizontalSpacing(2 * kGrid);
    m_form->setVerticalSpacing(kGrid);
    m_form->addRow(tr("&Name"), m_name);
    m_form->addRow(tr("Vehicle"), m_system);
    m_form->addRow(tr("This station"), m_ours);
    m_form->addRow(tr("The agent"), m_theirs);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGrid);
    column->addWidget(m_code);
    column->addLayout(m_form);
    connect(m_name, &QLineEdit::textChanged, this, &PairingQuestionForm::nameChanged);
    showFingerprints(false);
}

void PairingQuestionForm::showQuestion(const PairingQuestion &question, bool withCode)
{
    m_code->setText(question.code);
    m_code->setVisible(withCode);
    m_system->setText(tr("system ID %1").arg(question.systemId));
    showRow(m_system, question.systemId != 0);
    m_theirs->setText(fingerprintLines(question.key));
    m_name->setText(question.name);
}

void PairingQuestionForm::showFingerprints(bool visible)
{
    showRow(m_ours, visible);
    showRow(m_theirs, visible);
}

void PairingQuestionForm::setNameEnabled(bool enabled)
{
    m_name->setEnabled(enabled);
}

QString PairingQuestionForm::name() const
{
    return m_name->text();
}

void PairingQuestionForm::showRow(QWidget *field, bool visible)
{
    field->setVisible(visible);
    m_form->labelForField(field)->setVisible(visible);
}

} // namespace skyseal::ui

#include "moc_pairing_question_form.cpp"
