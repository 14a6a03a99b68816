#pragma once

namespace skyseal::ui {

/// The colours of the track on the map say this.
enum class TrackColors : int { Suite, LinkQuality, Altitude, Speed };

} // namespace skyseal::ui
