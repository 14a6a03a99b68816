// The checklist of the shown vehicle, beside the reasons of the vehicle itself: ticked by a click or the space bar, or by the
// vehicle's values; its file is chosen here.
#pragma once

#include "ui/view_state.h"

#include <QtWidgets/QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace skyseal::ui {

class Preflight;

class ChecklistBox : public QWidget
{
    Q_OBJECT

public:
    /// `preflight` must outlive it.
    explicit ChecklistBox(Preflight &preflight, QWidget *parent = nullptr);

    void showViewState(const ViewState &view);

private:
    void choose();
    void refresh();

    Preflight &m_preflight;
    QLabel *m_title, *m_problems;
    QListWidget *m_list;
    QPushButton *m_choose, *m_remove;
    std::uint8_t m_systemId = 0; ///< 0: no vehicle, or that of a replay
};

} // namespace skyseal::ui
