// Whether this build has the parts that exist for comparison only: RC4, plain MAVLink in place of a sealed link, frames sealed
// in place, and MAVSec's published encryption. Built with -DSKYSEAL_RESEARCH=OFF, for aircraft in service, it has none of them:
// no offer, option or menu names them, and no setting enables them. Ends of both builds work together.
#pragma once

namespace skyseal {

#ifdef SKYSEAL_WITHOUT_RESEARCH
inline constexpr bool kResearch = false;
#else
inline constexpr bool kResearch = true;
#endif

} // namespace skyseal
