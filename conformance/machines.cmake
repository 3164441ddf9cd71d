# SPDX-License-Identifier: MIT
# The same programs once more: on Mesa's second software driver, on its off-screen library, with the layer beneath them
# in other ways than the preload, and in device time on machines that are the driver else. A subset: what is particular
# to a driver, a platform, a front or a clock shows in any.
set(every_query ${CONFORMANCE_DEVICES}/every-query.toml)

# Softpipe counts no generated primitives.
set(deletes In/EsObjects.deleting_the_active_object_leaves_it_active_until_its_end)
add_native_conformance(arb_occlusion_query REQUIRE GL_ARB_occlusion_query SOFTPIPE WITHOUT
  BeginEnd.the_object_of_the_conditional_rendering_in_progress_is_refused
  Counting.queries_of_different_targets_do_not_disturb_each_other
  GetQuery.a_name_without_object_cannot_be_labelled
  NamesInUse.deleting_the_active_object_leaves_it_active_until_its_end)
add_native_conformance(ext_occlusion_query_boolean REQUIRE GL_EXT_occlusion_query_boolean SOFTPIPE
                       WITHOUT ${deletes}/es2 ${deletes}/es3)

# The vendor library: no preload, GLVND itself loads the layer.
add_emulated_conformance(hp_occlusion_test REQUIRE GL_HP_occlusion_test DEVICE visualize-fx FRONT vendor)
add_emulated_conformance(hp_occlusion_test REQUIRE GL_HP_occlusion_test DEVICE visualize-fx FRONT vendor PLATFORM glx)
add_emulated_conformance(nv_occlusion_query REQUIRE GL_NV_occlusion_query DEVICE geforce3 FRONT vendor)
add_emulated_conformance(arb_occlusion_query REQUIRE GL_ARB_occlusion_query DEVICE geforce-fx-5950 CLOCK calls=50
                         FRONT vendor)
add_emulated_conformance(ext_occlusion_query_boolean REQUIRE GL_EXT_occlusion_query_boolean DEVICE radeon-hd5770
                         FRONT vendor)
add_emulated_conformance(nv_conditional_render REQUIRE GL_NVX_conditional_render DEVICE ${every_query} FRONT vendor)
add_emulated_conformance(overlap REQUIRE GL_NV_occlusion_query DEVICE ${every_query} FRONT vendor)
add_emulated_conformance(contexts REQUIRE GL_NV_occlusion_query DEVICE ${every_query} FRONT vendor)
add_emulated_conformance(transparency REQUIRE GL_HP_occlusion_test DEVICE ${every_query} FRONT vendor PLATFORM glx)

# OSMesa. It exports fewer names than libGL: the suites that read 64-bit results and addresses of libGL are left out.
set(osmesas_suites BeginEnd.* Counting.* GetQuery.* Names.* NamesInUse.* Order.* QueryLists.*)
add_native_conformance(arb_occlusion_query REQUIRE GL_ARB_occlusion_query PLATFORM osmesa ONLY ${osmesas_suites} WITHOUT
  BeginEnd.the_object_of_the_conditional_rendering_in_progress_is_refused
  GetQuery.a_name_without_object_cannot_be_labelled
  NamesInUse.deleting_the_active_object_leaves_it_active_until_its_end)

# The exporting library, under OSMesa: the one platform that has no other way in.
set(osmesa FRONT export PLATFORM osmesa)
add_emulated_conformance(hp_occlusion_test REQUIRE GL_HP_occlusion_test DEVICE visualize-fx CLOCK wall=50 ${osmesa})
add_emulated_conformance(nv_occlusion_query REQUIRE GL_NV_occlusion_query DEVICE geforce3 CLOCK calls=50 ${osmesa})
add_emulated_conformance(arb_occlusion_query REQUIRE GL_ARB_occlusion_query DEVICE geforce-fx-5950 ${osmesa})
add_emulated_conformance(nv_conditional_render REQUIRE GL_NVX_conditional_render DEVICE ${every_query} ${osmesa})
add_emulated_conformance(overlap REQUIRE GL_NV_occlusion_query DEVICE ${every_query} ${osmesa})
add_emulated_conformance(contexts REQUIRE GL_NV_occlusion_query DEVICE ${every_query} ${osmesa})
add_emulated_conformance(discovery DEVICE ${every_query} ${osmesa})
add_emulated_conformance(counting REQUIRE GL_NV_occlusion_query DEVICE ${every_query} ${osmesa}
                         ONLY ClippingCounts.* DepthCounts.* PrimitiveCounts.* StencilCounts.* TestsCount.*)

# Device time: the layer counts in the driver's other queries, and nobody may see it. Where a device changes nothing,
# the driver's departures from the texts are the device's.
set(only_time DEVICE ${CONFORMANCE_DEVICES}/only-time.toml CLOCK device)
add_emulated_conformance(arb_occlusion_query NAME only_time ${only_time} REQUIRE GL_ARB_occlusion_query WITHOUT
  BeginEnd.the_object_of_the_conditional_rendering_in_progress_is_refused
  GetQuery.a_name_without_object_cannot_be_labelled
  NamesInUse.deleting_the_active_object_leaves_it_active_until_its_end)
add_emulated_conformance(arb_pipeline_statistics_query NAME only_time ${only_time}
                         REQUIRE GL_ARB_pipeline_statistics_query)
add_emulated_conformance(arb_timer_query NAME only_time ${only_time} REQUIRE GL_ARB_timer_query)
add_emulated_conformance(contexts NAME only_time ${only_time})
# The second driver counts otherwise, and answers the same.
add_emulated_conformance(arb_timer_query NAME only_time ${only_time} REQUIRE GL_ARB_timer_query SOFTPIPE)
add_emulated_conformance(contexts NAME only_time ${only_time} SOFTPIPE)
set(emulated DEVICE ${CONFORMANCE_DEVICES}/proposals.toml CLOCK device)
add_emulated_conformance(emu_occlusion_unit NAME device ${emulated} REQUIRE GL_EMU_occlusion_unit
                         WITHOUT UnitShaders.with_early_tests_a_discarded_sample_counts)
add_emulated_conformance(nv_occlusion_query NAME device DEVICE geforce3 CLOCK device FRONT vendor PLATFORM glx
                         REQUIRE GL_NV_occlusion_query)
add_emulated_conformance(nv_occlusion_query NAME device DEVICE geforce3 CLOCK device ${osmesa}
                         REQUIRE GL_NV_occlusion_query)
