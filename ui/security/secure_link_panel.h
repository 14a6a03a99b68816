// The right dock: how the link is sealed, with whom, since when; the choice of the suite; what was counted. For a plain
// vehicle it says that nothing is sealed and what to do about it.
#pragma once

#include "ui/scene.h"

#include <QtWidgets/QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace skyseal::ui {

class CountersTable;
class SuiteActions;

class SecureLinkPanel : public QWidget
{
    Q_OBJECT

public:
    explicit SecureLinkPanel(SuiteActions &suites, QWidget *parent = nullptr);

    void showScene(const Scene &scene);

Q_SIGNALS:
    /// The operator picked another session of several: show its vehicle.
    void sessionChosen(quint32 session);
    void helpWanted(const QString &page);

private:
    void showHead(const Scene &scene);
    void showSessions(const Scene &scene);
    void showNote();

    SuiteActions &m_suites;
    QLabel *m_icon, *m_title, *m_peer, *m_since, *m_fingerprint, *m_note, *m_advice;
    QPushButton *m_help;
    QComboBox *m_sessions;
    QWidget *m_facts;
    CountersTable *m_counters;
};

} // namespace skyseal::ui
