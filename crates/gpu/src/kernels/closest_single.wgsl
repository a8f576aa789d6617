// Compiled from queries.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: d5a1ca4ec11ac0e8
// result: 4f2a9a2a367c97e2

struct Batch_std140_0
{
    @align(16) count_0 : u32,
    @align(4) capacity_0 : u32,
    @align(8) unused_0_0 : u32,
    @align(4) unused_1_0 : u32,
};

@binding(8) @group(0) var<uniform> batch_0 : Batch_std140_0;
@binding(4) @group(0) var<storage, read> views_0 : array<vec4<u32>>;

@binding(5) @group(0) var<storage, read> queries_0 : array<f32>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(3) @group(0) var<storage, read> tags_0 : array<u32>;

@binding(2) @group(0) var<storage, read> primitives_0 : array<f32>;

@binding(6) @group(0) var<storage, read_write> answers_0 : array<u32>;

@binding(7) @group(0) var<storage, read_write> values_0 : array<f32>;

struct ConeView_0
{
     apex_0 : vec3<f32>,
     axis_0 : vec3<f32>,
     margin_0 : f32,
     plane_margin_0 : f32,
     limit_0 : f32,
     groups_0 : u32,
     all_edges_0 : bool,
};

fn cone_view_0( query_0 : u32) -> ConeView_0
{
    var _S1 : u32 = u32(3) * query_0;
    var a_0 : vec4<u32> = views_0[_S1];
    var b_0 : vec4<u32> = views_0[_S1 + u32(1)];
    var c_0 : vec4<u32> = views_0[_S1 + u32(2)];
    var view_0 : ConeView_0;
    view_0.apex_0 = (bitcast<vec3<f32>>((a_0.xyz)));
    view_0.axis_0 = (bitcast<vec3<f32>>((b_0.xyz)));
    view_0.margin_0 = (bitcast<f32>((a_0.w)));
    view_0.plane_margin_0 = (bitcast<f32>((b_0.w)));
    view_0.limit_0 = (bitcast<f32>((c_0.x)));
    view_0.groups_0 = c_0.y;
    view_0.all_edges_0 = (c_0.z) != u32(0);
    return view_0;
}

fn query_vector_0( at_0 : u32) -> vec3<f32>
{
    return vec3<f32>(queries_0[at_0], queries_0[at_0 + u32(1)], queries_0[at_0 + u32(2)]);
}

struct Cone_0
{
     apex_1 : vec3<f32>,
     axis_1 : vec3<f32>,
     plane_point_0 : vec3<f32>,
     plane_normal_0 : vec3<f32>,
     on_plane_0 : f32,
     size_0 : f32,
     limit_1 : f32,
     all_edges_1 : bool,
};

fn cone_at_0( query_1 : u32,  all_edges_2 : bool) -> Cone_0
{
    var at_1 : u32 = u32(16) * query_1;
    var cone_0 : Cone_0;
    cone_0.apex_1 = query_vector_0(at_1);
    cone_0.axis_1 = query_vector_0(at_1 + u32(3));
    cone_0.plane_point_0 = query_vector_0(at_1 + u32(6));
    cone_0.plane_normal_0 = query_vector_0(at_1 + u32(9));
    cone_0.on_plane_0 = queries_0[at_1 + u32(12)];
    cone_0.size_0 = queries_0[at_1 + u32(13)];
    cone_0.limit_1 = queries_0[at_1 + u32(14)];
    cone_0.all_edges_1 = all_edges_2;
    return cone_0;
}

struct Nearest_0
{
     t_0 : f32,
     sin_0 : f32,
     cos_0 : f32,
     position_0 : vec3<f32>,
};

fn at_point_0( cone_1 : Cone_0,  t_1 : f32,  position_1 : vec3<f32>) -> Nearest_0
{
    var nearest_0 : Nearest_0;
    nearest_0.t_0 = t_1;
    nearest_0.position_0 = position_1;
    var across_0 : vec3<f32> = cross(cone_1.axis_1, position_1);
    nearest_0.sin_0 = sqrt(dot(across_0, across_0));
    nearest_0.cos_0 = dot(cone_1.axis_1, position_1);
    return nearest_0;
}

struct Box_0
{
     first_0 : vec3<f32>,
     second_0 : vec3<f32>,
     third_0 : vec3<f32>,
     half_size_0 : vec3<f32>,
};

fn reach_0( box_0 : Box_0,  v_0 : vec3<f32>) -> f32
{
    return abs(dot(box_0.first_0, v_0)) * box_0.half_size_0.x + abs(dot(box_0.second_0, v_0)) * box_0.half_size_0.y + abs(dot(box_0.third_0, v_0)) * box_0.half_size_0.z;
}

fn child_bound_0( view_1 : ConeView_0,  limit_2 : f32,  node_0 : u32,  slot_0 : u32) -> f32
{
    var at_2 : u32 = u32(4) * (u32(8) * node_0 + slot_0);
    var a_1 : vec4<u32> = nodes_0[at_2];
    var b_1 : vec4<u32> = nodes_0[at_2 + u32(1)];
    var c_1 : vec4<u32> = nodes_0[at_2 + u32(2)];
    var d_0 : vec4<u32> = nodes_0[at_2 + u32(3)];
    if((((d_0.w) & ((view_1.groups_0)))) == u32(0))
    {
        return 3.00000000549775576e+38f;
    }
    var centre_0 : vec3<f32> = (bitcast<vec3<f32>>((a_1.xyz))) - view_1.apex_0;
    var box_1 : Box_0;
    var _S2 : vec3<f32> = (bitcast<vec3<f32>>((b_1.xyz)));
    box_1.first_0 = _S2;
    var _S3 : vec3<f32> = (bitcast<vec3<f32>>((c_1.xyz)));
    box_1.second_0 = _S3;
    box_1.third_0 = cross(_S2, _S3);
    box_1.half_size_0 = vec3<f32>((bitcast<f32>((b_1.w))), (bitcast<f32>((c_1.w))), (bitcast<f32>((d_0.y))));
    var has_tangent_0 : bool;
    if(!view_1.all_edges_0)
    {
        var clearance_0 : f32 = abs(dot(box_1.first_0, centre_0)) - (bitcast<f32>((d_0.x))) - view_1.plane_margin_0;
        var sin_1 : f32 = (bitcast<f32>((a_1.w)));
        if(clearance_0 > 0.0f)
        {
            has_tangent_0 = (sin_1 * sin_1 * dot(centre_0, centre_0)) < (clearance_0 * clearance_0);
        }
        else
        {
            has_tangent_0 = false;
        }
        if(has_tangent_0)
        {
            return 3.00000000549775576e+38f;
        }
    }
    var any_reach_0 : f32 = (box_1.half_size_0.x + box_1.half_size_0.y + box_1.half_size_0.z) * 1.00999999046325684f;
    var z_0 : f32 = dot(view_1.axis_0, centre_0);
    var radial_0 : vec3<f32> = centre_0 - view_1.axis_0 * vec3<f32>(z_0);
    var _S4 : f32 = max(dot(radial_0, radial_0), 1.00000000317107685e-30f);
    var distance_0 : f32 = sqrt(_S4);
    var _S5 : bool = limit_2 < 1.0f;
    var tangent_0 : f32;
    if(_S5)
    {
        tangent_0 = limit_2 / max(1.0f - limit_2, 9.99999997475242708e-07f);
    }
    else
    {
        tangent_0 = 8.0f;
    }
    if(_S5)
    {
        has_tangent_0 = tangent_0 <= 8.0f;
    }
    else
    {
        has_tangent_0 = false;
    }
    var limit_slope_0 : f32 = distance_0 * (min(tangent_0, 8.0f) * 1.0009765625f);
    var slope_0 : f32;
    if(z_0 > 9.99999968265522539e-21f)
    {
        slope_0 = min(_S4 / z_0, limit_slope_0);
    }
    else
    {
        slope_0 = limit_slope_0;
    }
    var _S6 : f32 = distance_0 + any_reach_0;
    var at_zero_0 : f32 = _S4 - reach_0(box_1, radial_0) - view_1.margin_0 * _S6;
    var at_slope_0 : f32 = _S4 - slope_0 * z_0 - reach_0(box_1, radial_0 - view_1.axis_0 * vec3<f32>(slope_0)) - view_1.margin_0 * (distance_0 + slope_0 + any_reach_0);
    var _S7 : bool;
    if(at_slope_0 > 0.0f)
    {
        _S7 = limit_slope_0 <= slope_0;
    }
    else
    {
        _S7 = false;
    }
    if(_S7)
    {
    }
    else
    {
        has_tangent_0 = false;
    }
    if(has_tangent_0)
    {
        return 3.00000000549775576e+38f;
    }
    var highest_0 : f32 = z_0 + any_reach_0 + view_1.margin_0;
    var bound_0 : f32;
    if(highest_0 < 0.0f)
    {
        bound_0 = 1.0f - highest_0 / (_S6 + view_1.margin_0 - highest_0);
    }
    else
    {
        var _S8 : f32 = max(at_zero_0, 0.0f);
        var in_front_0 : f32 = slope_0 * _S8;
        var sum_0 : f32 = distance_0 * (_S8 - min(at_slope_0, 0.0f)) + in_front_0;
        if(sum_0 > 0.0f)
        {
            tangent_0 = in_front_0 / sum_0;
        }
        else
        {
            tangent_0 = 0.0f;
        }
        bound_0 = tangent_0;
    }
    return bound_0 * 0.9990234375f;
}

fn nearest_first_0( bounds_0 : array<f32, i32(8)>,  limit_3 : f32) -> u32
{
    var k_0 : u32 = u32(0);
    var order_0 : u32 = u32(0);
    for(;;)
    {
        if(k_0 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S9 : u32 = k_0;
        if((bounds_0[k_0]) > limit_3)
        {
            k_0 = k_0 + u32(1);
            continue;
        }
        var j_0 : u32 = u32(0);
        var rank_0 : u32 = u32(0);
        for(;;)
        {
            if(j_0 < u32(8))
            {
            }
            else
            {
                break;
            }
            var _S10 : u32 = j_0;
            var _S11 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S9]))
            {
                _S11 = true;
            }
            else
            {
                if((bounds_0[_S10]) == (bounds_0[_S9]))
                {
                    _S11 = j_0 < k_0;
                }
                else
                {
                    _S11 = false;
                }
            }
            if(_S11)
            {
                rank_0 = rank_0 + u32(1);
            }
            j_0 = j_0 + u32(1);
        }
        order_0 = (order_0 | ((((k_0 + u32(1)) << ((u32(4) * rank_0))))));
        k_0 = k_0 + u32(1);
    }
    return order_0;
}

fn reached_0( view_2 : ConeView_0,  limit_4 : f32,  node_1 : u32) -> u32
{
    var bounds_1 : array<f32, i32(8)>;
    var slot_1 : u32 = u32(0);
    for(;;)
    {
        if(slot_1 < u32(8))
        {
        }
        else
        {
            break;
        }
        bounds_1[slot_1] = child_bound_0(view_2, limit_4, node_1, slot_1);
        slot_1 = slot_1 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_4);
}

fn cone_child_0( node_2 : u32,  slot_2 : u32) -> u32
{
    return nodes_0[u32(4) * (u32(8) * node_2 + slot_2) + u32(3)].z;
}

fn primitive_vector_0( at_3 : u32) -> vec3<f32>
{
    return vec3<f32>(primitives_0[at_3], primitives_0[at_3 + u32(1)], primitives_0[at_3 + u32(2)]);
}

fn sum_of_sizes_0( v_1 : vec3<f32>) -> f32
{
    return abs(v_1.x) + abs(v_1.y) + abs(v_1.z);
}

fn side_seen_0( cone_2 : Cone_0,  from_0 : vec3<f32>,  size_1 : f32,  normal_0 : vec3<f32>,  length_0 : f32) -> i32
{
    var height_0 : f32 = dot(normal_0, from_0);
    var tolerance_0 : f32 = cone_2.on_plane_0 * size_1 * length_0;
    var _S12 : i32;
    if(height_0 > tolerance_0)
    {
        _S12 = i32(1);
    }
    else
    {
        _S12 = i32(0);
    }
    var _S13 : i32;
    if(height_0 < (- tolerance_0))
    {
        _S13 = i32(1);
    }
    else
    {
        _S13 = i32(0);
    }
    return _S12 - _S13;
}

fn beyond_0() -> f32
{
    return 4.0f;
}

fn is_nearer_0( p_0 : Nearest_0,  q_0 : Nearest_0) -> bool
{
    return (p_0.sin_0 * q_0.cos_0) < (q_0.sin_0 * p_0.cos_0);
}

fn closest_on_edge_0( cone_3 : Cone_0,  at_4 : u32,  nearest_1 : ptr<function, Nearest_0>) -> f32
{
    (*nearest_1) = at_point_0(cone_3, 0.0f, cone_3.axis_1);
    var start_0 : vec3<f32> = primitive_vector_0(at_4);
    var a_2 : vec3<f32> = start_0 - cone_3.apex_1;
    var along_0 : vec3<f32> = primitive_vector_0(at_4 + u32(3));
    var finish_0 : vec3<f32> = start_0 + along_0;
    var b_2 : vec3<f32> = a_2 + along_0;
    if(!cone_3.all_edges_1)
    {
        var size_2 : f32 = cone_3.size_0 + sum_of_sizes_0(start_0);
        var from_1 : vec3<f32> = cone_3.apex_1 - start_0;
        if((side_seen_0(cone_3, from_1, size_2, primitive_vector_0(at_4 + u32(6)), primitives_0[at_4 + u32(12)]) * side_seen_0(cone_3, from_1, size_2, primitive_vector_0(at_4 + u32(9)), primitives_0[at_4 + u32(13)])) > i32(0))
        {
            return beyond_0();
        }
    }
    var _S14 : bool;
    if((dot(start_0 - cone_3.plane_point_0, cone_3.plane_normal_0)) < 0.0f)
    {
        _S14 = (dot(finish_0 - cone_3.plane_point_0, cone_3.plane_normal_0)) < 0.0f;
    }
    else
    {
        _S14 = false;
    }
    if(_S14)
    {
        return beyond_0();
    }
    var normal_1 : vec3<f32> = cross(a_2, along_0);
    if((normal_1.x) == 0.0f)
    {
        _S14 = (normal_1.y) == 0.0f;
    }
    else
    {
        _S14 = false;
    }
    if(_S14)
    {
        _S14 = (normal_1.z) == 0.0f;
    }
    else
    {
        _S14 = false;
    }
    if(_S14)
    {
        _S14 = (dot(a_2, b_2)) <= 0.0f;
    }
    else
    {
        _S14 = false;
    }
    if(_S14)
    {
        return beyond_0();
    }
    var _S15 : Nearest_0 = at_point_0(cone_3, 0.0f, a_2);
    (*nearest_1) = _S15;
    var other_0 : Nearest_0 = at_point_0(cone_3, 1.0f, b_2);
    if(is_nearer_0(other_0, _S15))
    {
        (*nearest_1) = other_0;
    }
    var w_0 : vec3<f32> = cross(cone_3.axis_1, normal_1);
    var falls_0 : f32 = dot(along_0, w_0);
    if(falls_0 != 0.0f)
    {
        var t_2 : f32 = - dot(a_2, w_0) / falls_0;
        if(t_2 > 0.0f)
        {
            _S14 = t_2 < 1.0f;
        }
        else
        {
            _S14 = false;
        }
        if(_S14)
        {
            var other_1 : Nearest_0 = at_point_0(cone_3, t_2, a_2 + along_0 * vec3<f32>(t_2));
            if(is_nearer_0(other_1, (*nearest_1)))
            {
                (*nearest_1) = other_1;
            }
        }
    }
    var total_0 : f32 = (*nearest_1).sin_0 + abs((*nearest_1).cos_0);
    if(!(total_0 > 0.0f))
    {
        return beyond_0();
    }
    var _S16 : f32;
    if(((*nearest_1).cos_0) >= 0.0f)
    {
        _S16 = (*nearest_1).sin_0 / total_0;
    }
    else
    {
        _S16 = 1.0f - (*nearest_1).cos_0 / total_0;
    }
    return _S16;
}

@compute
@workgroup_size(64, 1, 1)
fn closest(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var query_2 : u32 = thread_0.x;
    if(query_2 >= (batch_0.count_0))
    {
        return;
    }
    var view_3 : ConeView_0 = cone_view_0(query_2);
    var _S17 : Cone_0 = cone_at_0(query_2, view_3.all_edges_0);
    var cone_4 : Cone_0 = _S17;
    var _S18 : Nearest_0 = at_point_0(_S17, 0.0f, cone_4.axis_1);
    var way_0 : array<vec2<u32>, i32(40)>;
    var found_0 : u32;
    if((view_3.limit_0) >= 0.0f)
    {
        found_0 = reached_0(view_3, view_3.limit_0, u32(0));
    }
    else
    {
        found_0 = u32(0);
    }
    way_0[i32(0)] = vec2<u32>(u32(0), found_0);
    var is_new_0 : bool = true;
    var limit_5 : f32 = view_3.limit_0;
    found_0 = u32(4294967295);
    var best_0 : Nearest_0 = _S18;
    var level_0 : u32 = u32(0);
    for(;;)
    {
        var here_0 : vec2<u32> = way_0[level_0];
        var _S19 : u32 = way_0[level_0].y;
        if(_S19 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            level_0 = level_0 - u32(1);
            continue;
        }
        var slot_3 : u32 = ((_S19 & (u32(15)))) - u32(1);
        way_0[level_0][i32(1)] = (_S19 >> (u32(4)));
        var _S20 : bool;
        if(!is_new_0)
        {
            _S20 = (child_bound_0(view_3, limit_5, here_0.x, slot_3)) > limit_5;
        }
        else
        {
            _S20 = false;
        }
        if(_S20)
        {
            continue;
        }
        var child_0 : u32 = cone_child_0(here_0.x, slot_3);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var level_1 : u32 = level_0 + u32(1);
            way_0[level_1] = vec2<u32>(child_0, reached_0(view_3, limit_5, child_0));
            is_new_0 = true;
            level_0 = level_1;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S21 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S22 : u32 = leaf_starts_0[leaf_0];
        var found_1 : u32 = found_0;
        var limit_6 : f32 = limit_5;
        var best_1 : Nearest_0 = best_0;
        var i_0 : u32 = _S22;
        for(;;)
        {
            if(i_0 < _S21)
            {
            }
            else
            {
                break;
            }
            var _S23 : u32 = u32(2) * i_0;
            if(((tags_0[_S23 + u32(1)] & ((view_3.groups_0)))) == u32(0))
            {
                i_0 = i_0 + u32(1);
                continue;
            }
            var nearest_2 : Nearest_0;
            var angle_0 : f32 = closest_on_edge_0(cone_4, u32(14) * i_0, &(nearest_2));
            var edge_0 : u32 = tags_0[_S23];
            var _S24 : bool;
            if(angle_0 < (cone_4.limit_1))
            {
                _S24 = true;
            }
            else
            {
                if(angle_0 == (cone_4.limit_1))
                {
                    _S24 = found_1 != u32(4294967295);
                }
                else
                {
                    _S24 = false;
                }
                var _S25 : bool;
                if(_S24)
                {
                    _S25 = edge_0 < found_1;
                }
                else
                {
                    _S25 = false;
                }
                _S24 = _S25;
            }
            var found_2 : u32;
            var limit_7 : f32;
            var best_2 : Nearest_0;
            if(_S24)
            {
                cone_4.limit_1 = angle_0;
                var _S26 : f32 = min(limit_6, angle_0 * 1.0009765625f);
                found_2 = edge_0;
                limit_7 = _S26;
                best_2 = nearest_2;
            }
            else
            {
                found_2 = found_1;
                limit_7 = limit_6;
                best_2 = best_1;
            }
            found_1 = found_2;
            limit_6 = limit_7;
            best_1 = best_2;
            i_0 = i_0 + u32(1);
        }
        is_new_0 = false;
        limit_5 = limit_6;
        found_0 = found_1;
        best_0 = best_1;
    }
    answers_0[query_2] = found_0;
    var _S27 : u32 = u32(4) * query_2;
    values_0[_S27] = best_0.t_0;
    values_0[_S27 + u32(1)] = best_0.position_0.x;
    values_0[_S27 + u32(2)] = best_0.position_0.y;
    values_0[_S27 + u32(3)] = best_0.position_0.z;
    return;
}
