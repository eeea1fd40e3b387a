// Queries of Embree 3 and 4, for embree_scene.cpp alone.
#pragma once

#if SACCADE_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

// Each calls one of Embree's functions for `rays`. `where` is the scene, behind the lanes of a packet.
namespace saccade::embree {

#if SACCADE_EMBREE == 3

inline void intersect(auto call, bool coherent, auto* rays, auto... where) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  call(where..., &context, rays);
}

inline void occluded(auto call, auto* rays, auto... where) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  call(where..., &context, rays);
}

#else

inline void intersect(auto call, bool coherent, auto* rays, auto... where) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  if (coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  call(where..., rays, &arguments);
}

inline void occluded(auto call, auto* rays, auto... where) {
  call(where..., rays, nullptr);
}

#endif

}  // namespace saccade::embree
