// The warning that a known peer has another key: both fingerprints, and a box that must be ticked before the key is replaced.
#pragma once

#include "core/channel/policy.h"

#include <QtCore/QString>
#include <QtWidgets/QFrame>

class QCheckBox;
class QLabel;

namespace skyseal::ui {

class ChangedKeyWarning : public QFrame
{
    Q_OBJECT

public:
    explicit ChangedKeyWarning(QWidget *parent = nullptr);

    /// Keeps the tick if the shown keys are the same as before.
    void showKeys(const QString &name, const channel::PublicKey &known, const channel::PublicKey &offered);
    /// True if the operator has confirmed that the key is replaced.
    bool isAccepted() const;

Q_SIGNALS:
    void acceptedChanged();

private:
    QLabel *m_icon, *m_text, *m_known, *m_offered;
    QCheckBox *m_accept;
    struct Case
    {
        QString name;
        channel::PublicKey known{}, offered{};
        bool operator==(const Case &) const = default;
    };
    Case m_shown;
};

} // namespace skyseal::ui
