// Compiled from queries.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: 4d0f77661657a545
// result: 5ea22e662aafa0d1

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) capacity_0 : u32,
    @align(4) primitives_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(5) @group(0) var<storage, read> queries_0 : array<f64>;

@binding(4) @group(0) var<storage, read> views_0 : array<vec4<u32>>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(2) @group(0) var<storage, read> primitives_1 : array<f64>;

@binding(3) @group(0) var<storage, read> rough_0 : array<vec4<u32>>;

@binding(6) @group(0) var<storage, read_write> answers_0 : array<u32>;

@binding(7) @group(0) var<storage, read_write> values_0 : array<f64>;

fn query_vector_0( at_0 : u32) -> vec3<f64>
{
    return vec3<f64>(queries_0[at_0], queries_0[at_0 + u32(1)], queries_0[at_0 + u32(2)]);
}

struct Ray_0
{
     origin_0 : vec3<f64>,
     shear_x_0 : f64,
     shear_y_0 : f64,
     inverse_z_0 : f64,
     t_min_0 : f64,
     t_max_0 : f64,
     local_per_t_0 : f64,
     enter_0 : f64,
     edge_on_0 : f64,
     largest_0 : f64,
};

fn ray_at_0( query_0 : u32) -> Ray_0
{
    var at_1 : u32 = u32(12) * query_0;
    var ray_0 : Ray_0;
    ray_0.origin_0 = query_vector_0(at_1);
    ray_0.shear_x_0 = queries_0[at_1 + u32(3)];
    ray_0.shear_y_0 = queries_0[at_1 + u32(4)];
    ray_0.inverse_z_0 = queries_0[at_1 + u32(5)];
    ray_0.t_min_0 = queries_0[at_1 + u32(6)];
    ray_0.t_max_0 = queries_0[at_1 + u32(7)];
    ray_0.local_per_t_0 = queries_0[at_1 + u32(8)];
    ray_0.enter_0 = queries_0[at_1 + u32(9)];
    ray_0.edge_on_0 = queries_0[at_1 + u32(10)];
    ray_0.largest_0 = queries_0[at_1 + u32(11)];
    return ray_0;
}

struct RayView_0
{
     inverse_0 : vec3<f32>,
     offset_near_0 : vec3<f32>,
     offset_far_0 : vec3<f32>,
     limit_0 : f32,
     margin_0 : f32,
     axes_0 : u32,
};

fn ray_view_0( query_1 : u32) -> RayView_0
{
    var _S1 : u32 = u32(3) * query_1;
    var a_0 : vec4<u32> = views_0[_S1];
    var b_0 : vec4<u32> = views_0[_S1 + u32(1)];
    var c_0 : vec4<u32> = views_0[_S1 + u32(2)];
    var view_0 : RayView_0;
    view_0.inverse_0 = (bitcast<vec3<f32>>((a_0.xyz)));
    view_0.offset_near_0 = (bitcast<vec3<f32>>((b_0.xyz)));
    view_0.offset_far_0 = (bitcast<vec3<f32>>((c_0.xyz)));
    view_0.limit_0 = (bitcast<f32>((a_0.w)));
    view_0.margin_0 = (bitcast<f32>((b_0.w)));
    view_0.axes_0 = c_0.w;
    return view_0;
}

fn ray_child_0( node_0 : u32,  slot_0 : u32) -> u32
{
    return nodes_0[u32(14) * node_0 + u32(12) + slot_0 / u32(4)][slot_0 % u32(4)];
}

fn ray_bound_0( view_1 : RayView_0,  limit_1 : f32,  node_1 : u32,  slot_1 : u32) -> f32
{
    var _S2 : u32 = u32(14) * node_1 + slot_1 / u32(4);
    var near_0 : f32 = 0.0f;
    var far_0 : f32 = limit_1;
    var axis_0 : u32 = u32(0);
    for(;;)
    {
        if(axis_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S3 : u32 = axis_0;
        var _S4 : u32 = _S2 + u32(2) * axis_0;
        var _S5 : u32 = slot_1 % u32(4);
        var low_0 : f32 = (bitcast<f32>((nodes_0[_S4][_S5])));
        var high_0 : f32 = (bitcast<f32>((nodes_0[_S4 + u32(6)][_S5])));
        var _S6 : bool = (view_1.inverse_0[axis_0]) < 0.0f;
        var _S7 : f32;
        if(_S6)
        {
            _S7 = high_0;
        }
        else
        {
            _S7 = low_0;
        }
        var _S8 : f32 = max(near_0, _S7 * view_1.inverse_0[_S3] - view_1.offset_near_0[axis_0]);
        var _S9 : f32;
        if(_S6)
        {
            _S9 = low_0;
        }
        else
        {
            _S9 = high_0;
        }
        var _S10 : f32 = min(far_0, _S9 * view_1.inverse_0[_S3] - view_1.offset_far_0[axis_0]);
        var _S11 : u32 = axis_0 + u32(1);
        near_0 = _S8;
        far_0 = _S10;
        axis_0 = _S11;
    }
    if(near_0 <= far_0)
    {
    }
    else
    {
        near_0 = 3.00000000549775576e+38f;
    }
    return near_0;
}

fn nearest_first_0( bounds_0 : array<f32, i32(8)>,  limit_2 : f32) -> u32
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
        var _S12 : u32 = k_0;
        if((bounds_0[k_0]) > limit_2)
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
            var _S13 : u32 = j_0;
            var _S14 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S12]))
            {
                _S14 = true;
            }
            else
            {
                if((bounds_0[_S13]) == (bounds_0[_S12]))
                {
                    _S14 = j_0 < k_0;
                }
                else
                {
                    _S14 = false;
                }
            }
            if(_S14)
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

fn crossed_0( view_2 : RayView_0,  limit_3 : f32,  node_2 : u32) -> u32
{
    var bounds_1 : array<f32, i32(8)>;
    var slot_2 : u32 = u32(0);
    for(;;)
    {
        if(slot_2 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S15 : f32;
        if((ray_child_0(node_2, slot_2)) == u32(4294967295))
        {
            _S15 = 3.00000000549775576e+38f;
        }
        else
        {
            _S15 = ray_bound_0(view_2, limit_3, node_2, slot_2);
        }
        bounds_1[slot_2] = _S15;
        slot_2 = slot_2 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn primitive_vector_0( at_2 : u32) -> vec3<f64>
{
    return vec3<f64>(primitives_1[at_2], primitives_1[at_2 + u32(1)], primitives_1[at_2 + u32(2)]);
}

fn component_0( v_0 : vec3<f64>,  axis_1 : u32) -> f64
{
    var _S16 : f64;
    if(axis_1 == u32(0))
    {
        _S16 = v_0.x;
    }
    else
    {
        if(axis_1 == u32(1))
        {
            _S16 = v_0.y;
        }
        else
        {
            _S16 = v_0.z;
        }
    }
    return _S16;
}

fn rounded_0( product_0 : f64,  largest_1 : f64) -> f64
{
    return min(product_0, largest_1);
}

fn corner_0( ray_1 : Ray_0,  axes_1 : u32,  at_3 : u32) -> vec3<f64>
{
    var relative_0 : vec3<f64> = primitive_vector_0(at_3) - ray_1.origin_0;
    var z_0 : f64 = component_0(relative_0, (axes_1 >> (u32(4))));
    return vec3<f64>(component_0(relative_0, (axes_1 & (u32(3)))) - rounded_0(ray_1.shear_x_0 * z_0, ray_1.largest_0), component_0(relative_0, (((axes_1 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_1.shear_y_0 * z_0, ray_1.largest_0), z_0);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_0 : f64,
     v_1 : f64,
     w_0 : f64,
};

fn intersect_0( ray_2 : Ray_0,  axes_2 : u32,  at_4 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_0 = 0.0lf;
    crossing_0.v_1 = 0.0lf;
    crossing_0.w_0 = 0.0lf;
    var a_1 : vec3<f64> = corner_0(ray_2, axes_2, at_4);
    var b_1 : vec3<f64> = corner_0(ray_2, axes_2, at_4 + u32(3));
    var c_1 : vec3<f64> = corner_0(ray_2, axes_2, at_4 + u32(6));
    var _S17 : f64 = c_1.x;
    var _S18 : f64 = b_1.y;
    var cx_by_0 : f64 = rounded_0(_S17 * _S18, ray_2.largest_0);
    var _S19 : f64 = c_1.y;
    var _S20 : f64 = b_1.x;
    var cy_bx_0 : f64 = rounded_0(_S19 * _S20, ray_2.largest_0);
    var _S21 : f64 = a_1.x;
    var ax_cy_0 : f64 = rounded_0(_S21 * _S19, ray_2.largest_0);
    var _S22 : f64 = a_1.y;
    var ay_cx_0 : f64 = rounded_0(_S22 * _S17, ray_2.largest_0);
    var bx_ay_0 : f64 = rounded_0(_S20 * _S22, ray_2.largest_0);
    var by_ax_0 : f64 = rounded_0(_S18 * _S21, ray_2.largest_0);
    var u_0 : f64 = cx_by_0 - cy_bx_0;
    var v_2 : f64 = ax_cy_0 - ay_cx_0;
    var w_1 : f64 = bx_ay_0 - by_ax_0;
    var _S23 : f64 = min(min(u_0, v_2), w_1);
    var _S24 : f64 = max(max(u_0, v_2), w_1);
    var _S25 : bool;
    if(_S23 < 0.0lf)
    {
        _S25 = _S24 > 0.0lf;
    }
    else
    {
        _S25 = false;
    }
    if(_S25)
    {
        return crossing_0;
    }
    var determinant_0 : f64 = u_0 + v_2 + w_1;
    if(_S23 <= 0.0lf)
    {
        _S25 = _S24 >= 0.0lf;
    }
    else
    {
        _S25 = false;
    }
    if(_S25)
    {
        if((abs(determinant_0)) <= (ray_2.edge_on_0 * (abs(cx_by_0) + abs(cy_bx_0) + abs(ax_cy_0) + abs(ay_cx_0) + abs(bx_ay_0) + abs(by_ax_0))))
        {
            return crossing_0;
        }
    }
    if(determinant_0 == 0.0lf)
    {
        return crossing_0;
    }
    var t_1 : f64 = (rounded_0(u_0 * a_1.z, ray_2.largest_0) + rounded_0(v_2 * b_1.z, ray_2.largest_0) + rounded_0(w_1 * c_1.z, ray_2.largest_0)) / determinant_0 * ray_2.inverse_z_0;
    if((ray_2.t_min_0) <= t_1)
    {
        _S25 = t_1 <= (ray_2.t_max_0);
    }
    else
    {
        _S25 = false;
    }
    crossing_0.is_hit_0 = _S25;
    crossing_0.t_0 = t_1;
    crossing_0.v_1 = v_2 / determinant_0;
    crossing_0.w_0 = w_1 / determinant_0;
    return crossing_0;
}

fn face_0( triangle_0 : u32) -> u32
{
    return rough_0[triangle_0 / u32(4)][triangle_0 % u32(4)];
}

struct Found_0
{
     face_1 : u32,
     triangle_1 : u32,
     v_3 : f64,
     w_2 : f64,
};

fn first_found_0( view_3 : RayView_0,  ray_3 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S26 : bool;
    var found_0 : Found_0;
    found_0.face_1 = u32(4294967295);
    found_0.triangle_1 = u32(4294967295);
    found_0.v_3 = 0.0lf;
    found_0.w_2 = 0.0lf;
    if(!((view_3.limit_0) >= 0.0f))
    {
        return found_0;
    }
    var way_0 : array<vec2<u32>, i32(40)>;
    way_0[i32(0)] = vec2<u32>(u32(0), u32(0));
    var entered_0 : u32 = u32(0);
    var limit_4 : f32 = view_3.limit_0;
    var is_new_0 : bool = true;
    var level_0 : u32 = u32(0);
    for(;;)
    {
        var entered_1 : u32;
        var is_new_1 : bool;
        if(entered_0 != u32(4294967295))
        {
            way_0[level_0] = vec2<u32>(entered_0, crossed_0(view_3, limit_4, entered_0));
            is_new_1 = true;
            entered_1 = u32(4294967295);
        }
        else
        {
            is_new_1 = is_new_0;
            entered_1 = entered_0;
        }
        var here_0 : vec2<u32> = way_0[level_0];
        var _S27 : u32 = way_0[level_0].y;
        if(_S27 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S28 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S28;
            continue;
        }
        var slot_3 : u32 = ((_S27 & (u32(15)))) - u32(1);
        way_0[level_0][i32(1)] = (_S27 >> (u32(4)));
        var _S29 : bool;
        if(!is_new_1)
        {
            _S29 = (ray_bound_0(view_3, limit_4, here_0.x, slot_3)) > limit_4;
        }
        else
        {
            _S29 = false;
        }
        if(_S29)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_0.x, slot_3);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S30 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S30;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S31 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S32 : u32 = leaf_starts_0[leaf_0];
        var limit_5 : f32 = limit_4;
        var i_0 : u32 = _S32;
        for(;;)
        {
            if(i_0 < _S31)
            {
            }
            else
            {
                break;
            }
            var crossing_1 : Crossing_0 = intersect_0((*ray_3), view_3.axes_0, u32(9) * i_0);
            if(!crossing_1.is_hit_0)
            {
                i_0 = i_0 + u32(1);
                continue;
            }
            if((found_0.face_1) == u32(4294967295))
            {
                _S26 = true;
            }
            else
            {
                _S26 = (crossing_1.t_0) < ((*ray_3).t_max_0);
            }
            var _S33 : bool;
            if(_S26)
            {
                _S33 = true;
            }
            else
            {
                _S33 = (face_0(i_0)) < (found_0.face_1);
            }
            var limit_6 : f32;
            if(_S33)
            {
                found_0.face_1 = face_0(i_0);
                found_0.triangle_1 = i_0;
                (*ray_3).t_max_0 = crossing_1.t_0;
                found_0.v_3 = crossing_1.v_1;
                found_0.w_2 = crossing_1.w_0;
                limit_6 = min(limit_5, f32(crossing_1.t_0 * (*ray_3).local_per_t_0 - (*ray_3).enter_0) + 2.0f * view_3.margin_0);
            }
            else
            {
                limit_6 = limit_5;
            }
            limit_5 = limit_6;
            i_0 = i_0 + u32(1);
        }
        if(any_0)
        {
            _S26 = (found_0.face_1) != u32(4294967295);
        }
        else
        {
            _S26 = false;
        }
        if(_S26)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_0;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S34 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S35 : u32 = u32(2) + zero_0;
        _S34 = _S35;
        if(rounds_0 < _S35)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S34;
}

fn is_cut_short_0() -> bool
{
    return !loops_end_0(((launch_0.end_0) >> (u32(31))));
}

fn trace_0( query_2 : u32,  any_1 : bool)
{
    var ray_4 : Ray_0 = ray_at_0(query_2);
    var found_1 : Found_0 = first_found_0(ray_view_0(query_2), &(ray_4), any_1);
    var _S36 : u32;
    if(is_cut_short_0())
    {
        _S36 = u32(4294967294);
    }
    else
    {
        _S36 = found_1.face_1;
    }
    answers_0[query_2] = _S36;
    if(!any_1)
    {
        var _S37 : u32 = u32(3) * query_2;
        values_0[_S37] = ray_4.t_max_0;
        values_0[_S37 + u32(1)] = found_1.v_3;
        values_0[_S37 + u32(2)] = found_1.w_2;
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn first_hit(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var query_3 : u32 = launch_0.first_0 + thread_0.x;
    if(query_3 < (launch_0.end_0))
    {
        trace_0(query_3, false);
    }
    return;
}
