// Compiled from render.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: 062a046754b034e0
// result: b918436c00d04462

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) room_0 : u32,
    @align(4) depth_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(5) @group(0) var<storage, read> input_0 : array<u32>;

@binding(4) @group(0) var<storage, read> scene_0 : array<u32>;

@binding(2) @group(0) var<storage, read> primitives_0 : array<f64>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(3) @group(0) var<storage, read> rough_0 : array<vec4<u32>>;

@binding(6) @group(0) var<storage, read_write> paths_0 : array<u32>;

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

fn changing_0( value_0 : vec3<f32>,  change_0 : vec3<f32>) -> vec3<f32>
{
    return value_0;
}

fn still_0( value_1 : vec3<f32>) -> vec3<f32>
{
    return changing_0(value_1, vec3<f32>(0.0f));
}

fn word_0( at_0 : u32) -> u32
{
    return scene_0[at_0];
}

fn component_0( v_0 : vec3<f64>,  axis_0 : u32) -> f64
{
    var _S1 : f64;
    if(axis_0 == u32(0))
    {
        _S1 = v_0.x;
    }
    else
    {
        if(axis_0 == u32(1))
        {
            _S1 = v_0.y;
        }
        else
        {
            _S1 = v_0.z;
        }
    }
    return _S1;
}

fn limit_at_0( which_0 : u32) -> f64
{
    return primitives_0[word_0(u32(13)) + which_0];
}

fn ray_child_0( node_0 : u32,  slot_0 : u32) -> u32
{
    return nodes_0[u32(14) * node_0 + u32(12) + slot_0 / u32(4)][slot_0 % u32(4)];
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

fn ray_bound_0( view_0 : RayView_0,  limit_1 : f32,  node_1 : u32,  slot_1 : u32) -> f32
{
    var _S2 : u32 = u32(14) * node_1 + slot_1 / u32(4);
    var near_0 : f32 = 0.0f;
    var far_0 : f32 = limit_1;
    var axis_1 : u32 = u32(0);
    for(;;)
    {
        if(axis_1 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S3 : u32 = axis_1;
        var _S4 : u32 = _S2 + u32(2) * axis_1;
        var _S5 : u32 = slot_1 % u32(4);
        var low_0 : f32 = (bitcast<f32>((nodes_0[_S4][_S5])));
        var high_0 : f32 = (bitcast<f32>((nodes_0[_S4 + u32(6)][_S5])));
        var _S6 : bool = (view_0.inverse_0[axis_1]) < 0.0f;
        var _S7 : f32;
        if(_S6)
        {
            _S7 = high_0;
        }
        else
        {
            _S7 = low_0;
        }
        var _S8 : f32 = max(near_0, _S7 * view_0.inverse_0[_S3] - view_0.offset_near_0[axis_1]);
        var _S9 : f32;
        if(_S6)
        {
            _S9 = low_0;
        }
        else
        {
            _S9 = high_0;
        }
        var _S10 : f32 = min(far_0, _S9 * view_0.inverse_0[_S3] - view_0.offset_far_0[axis_1]);
        var _S11 : u32 = axis_1 + u32(1);
        near_0 = _S8;
        far_0 = _S10;
        axis_1 = _S11;
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

fn crossed_0( view_1 : RayView_0,  limit_3 : f32,  node_2 : u32) -> u32
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
            _S15 = ray_bound_0(view_1, limit_3, node_2, slot_2);
        }
        bounds_1[slot_2] = _S15;
        slot_2 = slot_2 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn primitive_vector_0( at_1 : u32) -> vec3<f64>
{
    return vec3<f64>(primitives_0[at_1], primitives_0[at_1 + u32(1)], primitives_0[at_1 + u32(2)]);
}

fn rounded_0( product_0 : f64,  largest_0 : f64) -> f64
{
    return min(product_0, largest_0);
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
     largest_1 : f64,
};

fn corner_0( ray_0 : Ray_0,  axes_1 : u32,  at_2 : u32) -> vec3<f64>
{
    var relative_0 : vec3<f64> = primitive_vector_0(at_2) - ray_0.origin_0;
    var z_0 : f64 = component_0(relative_0, (axes_1 >> (u32(4))));
    return vec3<f64>(component_0(relative_0, (axes_1 & (u32(3)))) - rounded_0(ray_0.shear_x_0 * z_0, ray_0.largest_1), component_0(relative_0, (((axes_1 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_0.shear_y_0 * z_0, ray_0.largest_1), z_0);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_0 : f64,
     v_1 : f64,
     w_0 : f64,
};

fn intersect_0( ray_1 : Ray_0,  axes_2 : u32,  at_3 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_0 = 0.0lf;
    crossing_0.v_1 = 0.0lf;
    crossing_0.w_0 = 0.0lf;
    var a_0 : vec3<f64> = corner_0(ray_1, axes_2, at_3);
    var b_0 : vec3<f64> = corner_0(ray_1, axes_2, at_3 + u32(3));
    var c_0 : vec3<f64> = corner_0(ray_1, axes_2, at_3 + u32(6));
    var _S16 : f64 = c_0.x;
    var _S17 : f64 = b_0.y;
    var cx_by_0 : f64 = rounded_0(_S16 * _S17, ray_1.largest_1);
    var _S18 : f64 = c_0.y;
    var _S19 : f64 = b_0.x;
    var cy_bx_0 : f64 = rounded_0(_S18 * _S19, ray_1.largest_1);
    var _S20 : f64 = a_0.x;
    var ax_cy_0 : f64 = rounded_0(_S20 * _S18, ray_1.largest_1);
    var _S21 : f64 = a_0.y;
    var ay_cx_0 : f64 = rounded_0(_S21 * _S16, ray_1.largest_1);
    var bx_ay_0 : f64 = rounded_0(_S19 * _S21, ray_1.largest_1);
    var by_ax_0 : f64 = rounded_0(_S17 * _S20, ray_1.largest_1);
    var u_0 : f64 = cx_by_0 - cy_bx_0;
    var v_2 : f64 = ax_cy_0 - ay_cx_0;
    var w_1 : f64 = bx_ay_0 - by_ax_0;
    var _S22 : f64 = min(min(u_0, v_2), w_1);
    var _S23 : f64 = max(max(u_0, v_2), w_1);
    var _S24 : bool;
    if(_S22 < 0.0lf)
    {
        _S24 = _S23 > 0.0lf;
    }
    else
    {
        _S24 = false;
    }
    if(_S24)
    {
        return crossing_0;
    }
    var determinant_0 : f64 = u_0 + v_2 + w_1;
    if(_S22 <= 0.0lf)
    {
        _S24 = _S23 >= 0.0lf;
    }
    else
    {
        _S24 = false;
    }
    if(_S24)
    {
        if((abs(determinant_0)) <= (ray_1.edge_on_0 * (abs(cx_by_0) + abs(cy_bx_0) + abs(ax_cy_0) + abs(ay_cx_0) + abs(bx_ay_0) + abs(by_ax_0))))
        {
            return crossing_0;
        }
    }
    if(determinant_0 == 0.0lf)
    {
        return crossing_0;
    }
    var t_1 : f64 = (rounded_0(u_0 * a_0.z, ray_1.largest_1) + rounded_0(v_2 * b_0.z, ray_1.largest_1) + rounded_0(w_1 * c_0.z, ray_1.largest_1)) / determinant_0 * ray_1.inverse_z_0;
    if((ray_1.t_min_0) <= t_1)
    {
        _S24 = t_1 <= (ray_1.t_max_0);
    }
    else
    {
        _S24 = false;
    }
    crossing_0.is_hit_0 = _S24;
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

fn first_found_0( view_2 : RayView_0,  ray_2 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S25 : bool;
    var found_0 : Found_0;
    found_0.face_1 = u32(4294967295);
    found_0.triangle_1 = u32(4294967295);
    found_0.v_3 = 0.0lf;
    found_0.w_2 = 0.0lf;
    if(!((view_2.limit_0) >= 0.0f))
    {
        return found_0;
    }
    var way_0 : array<vec2<u32>, i32(40)>;
    way_0[i32(0)] = vec2<u32>(u32(0), u32(0));
    var entered_0 : u32 = u32(0);
    var limit_4 : f32 = view_2.limit_0;
    var is_new_0 : bool = true;
    var level_0 : u32 = u32(0);
    for(;;)
    {
        var entered_1 : u32;
        var is_new_1 : bool;
        if(entered_0 != u32(4294967295))
        {
            way_0[level_0] = vec2<u32>(entered_0, crossed_0(view_2, limit_4, entered_0));
            is_new_1 = true;
            entered_1 = u32(4294967295);
        }
        else
        {
            is_new_1 = is_new_0;
            entered_1 = entered_0;
        }
        var here_0 : vec2<u32> = way_0[level_0];
        var _S26 : u32 = way_0[level_0].y;
        if(_S26 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S27 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S27;
            continue;
        }
        var slot_3 : u32 = ((_S26 & (u32(15)))) - u32(1);
        way_0[level_0][i32(1)] = (_S26 >> (u32(4)));
        var _S28 : bool;
        if(!is_new_1)
        {
            _S28 = (ray_bound_0(view_2, limit_4, here_0.x, slot_3)) > limit_4;
        }
        else
        {
            _S28 = false;
        }
        if(_S28)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_0.x, slot_3);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S29 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S29;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S30 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S31 : u32 = leaf_starts_0[leaf_0];
        var limit_5 : f32 = limit_4;
        var i_0 : u32 = _S31;
        for(;;)
        {
            if(i_0 < _S30)
            {
            }
            else
            {
                break;
            }
            var crossing_1 : Crossing_0 = intersect_0((*ray_2), view_2.axes_0, u32(9) * i_0);
            if(!crossing_1.is_hit_0)
            {
                i_0 = i_0 + u32(1);
                continue;
            }
            if((found_0.face_1) == u32(4294967295))
            {
                _S25 = true;
            }
            else
            {
                _S25 = (crossing_1.t_0) < ((*ray_2).t_max_0);
            }
            var _S32 : bool;
            if(_S25)
            {
                _S32 = true;
            }
            else
            {
                _S32 = (face_0(i_0)) < (found_0.face_1);
            }
            var limit_6 : f32;
            if(_S32)
            {
                found_0.face_1 = face_0(i_0);
                found_0.triangle_1 = i_0;
                (*ray_2).t_max_0 = crossing_1.t_0;
                found_0.v_3 = crossing_1.v_1;
                found_0.w_2 = crossing_1.w_0;
                limit_6 = min(limit_5, f32(crossing_1.t_0 * (*ray_2).local_per_t_0 - (*ray_2).enter_0) + 2.0f * view_2.margin_0);
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
            _S25 = (found_0.face_1) != u32(4294967295);
        }
        else
        {
            _S25 = false;
        }
        if(_S25)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_0;
}

fn cast_0( origin_1 : vec3<f64>,  direction_0 : vec3<f64>,  t_min_1 : f64,  t_max_1 : f64,  any_1 : bool,  t_2 : ptr<function, f32>) -> Found_0
{
    var size_0 : vec3<f32> = abs(vec3<f32>(direction_0));
    var _S33 : f32 = size_0.x;
    var _S34 : f32 = size_0.y;
    var _S35 : bool;
    if(_S33 >= _S34)
    {
        _S35 = _S33 >= (size_0.z);
    }
    else
    {
        _S35 = false;
    }
    var _S36 : i32;
    if(_S35)
    {
        _S36 = i32(0);
    }
    else
    {
        if(_S34 >= (size_0.z))
        {
            _S36 = i32(1);
        }
        else
        {
            _S36 = i32(2);
        }
    }
    var z_1 : u32 = u32(_S36);
    var x_0 : u32 = (z_1 + u32(1)) % u32(3);
    var y_0 : u32 = (z_1 + u32(2)) % u32(3);
    var ray_3 : Ray_0;
    ray_3.origin_0 = origin_1;
    var along_0 : f64 = component_0(direction_0, z_1);
    ray_3.inverse_z_0 = 1.0lf / along_0;
    ray_3.shear_x_0 = component_0(direction_0, x_0) / along_0;
    ray_3.shear_y_0 = component_0(direction_0, y_0) / along_0;
    ray_3.t_min_0 = t_min_1;
    ray_3.t_max_0 = t_max_1;
    var _S37 : f64 = abs(along_0);
    ray_3.local_per_t_0 = _S37;
    ray_3.enter_0 = 0.0lf;
    ray_3.edge_on_0 = limit_at_0(u32(0));
    ray_3.largest_1 = limit_at_0(u32(1));
    var view_3 : RayView_0;
    var _S38 : vec3<f32> = vec3<f32>(direction_0 / vec3<f64>(_S37));
    var axis_2 : u32 = u32(0);
    for(;;)
    {
        if(axis_2 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S39 : f32 = max(abs(_S38[axis_2]), 8.67361737988403547e-19f);
        var _S40 : f32;
        if((_S38[axis_2]) < 0.0f)
        {
            _S40 = -1.0f / _S39;
        }
        else
        {
            _S40 = 1.0f / _S39;
        }
        view_3.inverse_0[axis_2] = _S40;
        axis_2 = axis_2 + u32(1);
    }
    var offset_0 : vec3<f32> = vec3<f32>(origin_1) * view_3.inverse_0;
    var wider_0 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_3.inverse_0);
    view_3.offset_near_0 = offset_0 + wider_0;
    view_3.offset_far_0 = offset_0 - wider_0;
    view_3.limit_0 = min(f32(t_max_1 * ray_3.local_per_t_0), 8.0f) + 3.814697265625e-06f;
    view_3.margin_0 = 3.814697265625e-06f;
    view_3.axes_0 = (((x_0 | (((y_0 << (u32(2))))))) | (((z_1 << (u32(4))))));
    var found_1 : Found_0 = first_found_0(view_3, &(ray_3), any_1);
    (*t_2) = f32(ray_3.t_max_0);
    return found_1;
}

struct Place_0
{
     triangle_2 : u32,
     v_4 : f32,
     w_3 : f32,
     v_rest_0 : f32,
     w_rest_0 : f32,
};

fn exact_place_0( triangle_3 : u32,  v_5 : f64,  w_4 : f64) -> Place_0
{
    var place_0 : Place_0;
    place_0.triangle_2 = triangle_3;
    var _S41 : f32 = f32(v_5);
    place_0.v_4 = _S41;
    var _S42 : f32 = f32(w_4);
    place_0.w_3 = _S42;
    place_0.v_rest_0 = f32(v_5 - f64(_S41));
    place_0.w_rest_0 = f32(w_4 - f64(_S42));
    return place_0;
}

fn place_of_0( found_2 : Found_0) -> Place_0
{
    return exact_place_0(found_2.triangle_1, found_2.v_3, found_2.w_2);
}

fn triangle_record_0( triangle_4 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_4;
}

fn shape_of_0( triangle_5 : u32) -> u32
{
    return word_0(u32(10)) + u32(6) * word_0(triangle_record_0(triangle_5));
}

fn cross_of_0( triangle_6 : u32) -> vec3<f32>
{
    var at_4 : u32 = u32(9) * triangle_6;
    var a_1 : vec3<f64> = primitive_vector_0(at_4);
    return cross(vec3<f32>(primitive_vector_0(at_4 + u32(3)) - a_1), vec3<f32>(primitive_vector_0(at_4 + u32(6)) - a_1));
}

fn emitter_seen_0( found_3 : Found_0,  direction_1 : vec3<f32>) -> u32
{
    if((found_3.face_1) == u32(4294967295))
    {
        return word_0(u32(8));
    }
    var emitter_0 : u32 = word_0(shape_of_0(found_3.triangle_1) + u32(4));
    var _S43 : bool;
    if(emitter_0 != u32(4294967295))
    {
        _S43 = (dot(cross_of_0(found_3.triangle_1), direction_1)) < 0.0f;
    }
    else
    {
        _S43 = false;
    }
    var _S44 : u32;
    if(_S43)
    {
        _S44 = emitter_0;
    }
    else
    {
        _S44 = u32(4294967295);
    }
    return _S44;
}

fn emitter_record_0( emitter_1 : u32) -> u32
{
    return word_0(u32(11)) + u32(12) * emitter_1;
}

fn is_map_0( record_0 : u32) -> bool
{
    return (word_0(record_0)) == u32(2);
}

struct Lookup_0
{
     count_0 : u32,
     texels_0 : vec4<u32>,
     weights_0 : vec4<f32>,
};

fn one_texel_0( texel_0 : u32) -> Lookup_0
{
    var lookup_0 : Lookup_0;
    lookup_0.count_0 = u32(1);
    lookup_0.texels_0 = vec4<u32>(texel_0, u32(0), u32(0), u32(0));
    lookup_0.weights_0 = vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f);
    return lookup_0;
}

struct Corners2_0
{
     a_2 : vec2<f32>,
     b_1 : vec2<f32>,
     c_1 : vec2<f32>,
};

fn Corners2_x24init_0( a_3 : vec2<f32>,  b_2 : vec2<f32>,  c_2 : vec2<f32>) -> Corners2_0
{
    var _S45 : Corners2_0;
    _S45.a_2 = a_3;
    _S45.b_1 = b_2;
    _S45.c_1 = c_2;
    return _S45;
}

fn number_0( at_5 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_5])));
}

fn uvs_of_0( triangle_7 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f32>(0.0f), vec2<f32>(1.0f, 0.0f), vec2<f32>(0.0f, 1.0f));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_7) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_6 : u32 = uvs_at_0 + u32(6) * word_0(triangle_record_0(triangle_7) + u32(1));
    uvs_0.a_2 = vec2<f32>(number_0(at_6), number_0(at_6 + u32(1)));
    uvs_0.b_1 = vec2<f32>(number_0(at_6 + u32(2)), number_0(at_6 + u32(3)));
    uvs_0.c_1 = vec2<f32>(number_0(at_6 + u32(4)), number_0(at_6 + u32(5)));
    return uvs_0;
}

fn vector_at_0( at_7 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_7), number_0(at_7 + u32(1)), number_0(at_7 + u32(2)));
}

fn floor_of_0( x_1 : f32) -> i32
{
    return i32(floor(clamp(x_1, -1.0e+09f, 1.0e+09f)));
}

fn wrapped_0( i_1 : i32,  n_0 : i32,  wrap_0 : u32) -> u32
{
    if(wrap_0 == u32(2))
    {
        return u32(clamp(i_1, i32(0), n_0 - i32(1)));
    }
    var period_0 : i32;
    if(wrap_0 == u32(1))
    {
        period_0 = i32(2) * n_0;
    }
    else
    {
        period_0 = n_0;
    }
    var inside_0 : i32 = i_1 % period_0;
    var inside_1 : i32;
    if(inside_0 < i32(0))
    {
        inside_1 = inside_0 + period_0;
    }
    else
    {
        inside_1 = inside_0;
    }
    if(inside_1 < n_0)
    {
        period_0 = inside_1;
    }
    else
    {
        period_0 = i32(2) * n_0 - i32(1) - inside_1;
    }
    return u32(period_0);
}

struct Point_0
{
     value_2 : vec2<f32>,
};

fn between_0( texels_1 : vec4<u32>,  place_1 : Point_0) -> Lookup_0
{
    var way_1 : vec2<f32> = place_1.value_2 - floor(place_1.value_2);
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - way_1;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S46 : f32 = back_0.x;
    var _S47 : f32 = back_0.y;
    var _S48 : f32 = way_1.x;
    var _S49 : f32 = way_1.y;
    lookup_1.weights_0 = vec4<f32>(_S46 * _S47, _S48 * _S47, _S46 * _S49, _S48 * _S49);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_0 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var place_2 : vec2<f32> = uv_0.value_2 * vec2<f32>(f32(width_0), f32(height_0));
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_2.y), height_0, wrap_1);
        var _S50 : u32 = row_0 * u32(width_0);
        var _S51 : u32 = wrapped_0(floor_of_0(place_2.x), width_0, wrap_1);
        return one_texel_0(_S50 + _S51);
    }
    var centred_0 : Point_0;
    var _S52 : vec2<f32> = place_2 - vec2<f32>(0.5f);
    centred_0.value_2 = _S52;
    var x_2 : i32 = floor_of_0(_S52.x);
    var y_1 : i32 = floor_of_0(_S52.y);
    var _S53 : u32 = wrapped_0(y_1, height_0, wrap_1);
    var _S54 : u32 = u32(width_0);
    var first_1 : u32 = _S53 * _S54;
    var _S55 : u32 = wrapped_0(y_1 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S55 * _S54;
    var left_0 : u32 = wrapped_0(x_2, width_0, wrap_1);
    var right_0 : u32 = wrapped_0(x_2 + i32(1), width_0, wrap_1);
    return between_0(vec4<u32>(first_1 + left_0, first_1 + right_0, second_0 + left_0, second_0 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_3 : Place_0) -> Lookup_0
{
    var kind_0 : u32 = word_0(texture_1);
    if(kind_0 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_1 : u32 = triangle_record_0(place_3.triangle_2) + u32(1);
    if(kind_0 == u32(4))
    {
        return one_texel_0(word_0(record_1));
    }
    if(kind_0 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_1 + u32(1)), word_0(record_1 + u32(2)), word_0(record_1 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_3.v_4 - place_3.w_3, place_3.v_4, place_3.w_3, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_3.triangle_2);
    var rows_0 : u32 = texture_1 + u32(6);
    var uv_1 : Point_0;
    var _S56 : vec3<f32> = vec3<f32>(uvs_1.a_2 * vec2<f32>((1.0f - place_3.v_4 - place_3.w_3)) + uvs_1.b_1 * vec2<f32>(place_3.v_4) + uvs_1.c_1 * vec2<f32>(place_3.w_3), 1.0f);
    uv_1.value_2 = vec2<f32>(dot(_S56, vector_at_0(rows_0)), dot(_S56, vector_at_0(rows_0 + u32(3))));
    if(kind_0 == u32(1))
    {
        var _S57 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S57;
    }
    var half_of_period_0 : vec2<f32> = uv_1.value_2 - floor(uv_1.value_2);
    var _S58 : i32;
    if(((half_of_period_0.x) > 0.5f) != ((half_of_period_0.y) > 0.5f))
    {
        _S58 = i32(1);
    }
    else
    {
        _S58 = i32(0);
    }
    return one_texel_0(u32(_S58));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_1 : vec4<f32>) -> vec3<f32>
{
    var _S59 : u32 = word_0(texture_2 + u32(1));
    var _S60 : u32 = texture_2 + u32(13);
    var _S61 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_3 : vec3<f32> = _S61;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_8 : u32 = _S60 + _S59 * lookup_3.texels_0[k_1];
        var _S62 : vec3<f32>;
        if(_S59 == u32(1))
        {
            _S62 = vec3<f32>(number_0(at_8));
        }
        else
        {
            _S62 = vector_at_0(at_8);
        }
        var value_4 : vec3<f32> = value_3 + _S62 * vec3<f32>(weights_1[k_1]);
        k_1 = k_1 + u32(1);
        value_3 = value_4;
    }
    return value_3;
}

fn looked_up_0( texture_3 : u32,  lookup_4 : Lookup_0,  place_change_0 : vec2<f32>) -> vec3<f32>
{
    return weighted_texels_0(texture_3, lookup_4, lookup_4.weights_0);
}

fn shown_0( texture_4 : u32,  place_4 : Place_0) -> vec3<f32>
{
    var _S63 : Lookup_0 = lookup_at_0(texture_4, place_4);
    return looked_up_0(texture_4, _S63, vec2<f32>(0.0f));
}

fn value_of_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vector_0;
}

fn angle_of_0( x_3 : f32,  y_2 : f32) -> f32
{
    var _S64 : f32 = abs(x_3);
    var _S65 : f32 = abs(y_2);
    var _S66 : f32 = min(_S64, _S65);
    var _S67 : f32 = max(_S64, _S65);
    var is_steep_0 : bool = _S66 > (0.41421356797218323f * _S67);
    var above_0 : f32;
    if(is_steep_0)
    {
        above_0 = _S66 - _S67;
    }
    else
    {
        above_0 = _S66;
    }
    var below_0 : f32;
    if(is_steep_0)
    {
        below_0 = _S66 + _S67;
    }
    else
    {
        below_0 = _S67;
    }
    if(below_0 > 0.0f)
    {
    }
    else
    {
        below_0 = 1.0f;
    }
    var t_3 : f32 = above_0 / below_0;
    var z_2 : f32 = t_3 * t_3;
    var angle_0 : f32 = (((0.08053744584321976f * z_2 - 0.13877685368061066f) * z_2 + 0.19977711141109467f) * z_2 - 0.33332949876785278f) * z_2 * t_3 + t_3;
    var angle_1 : f32;
    if(is_steep_0)
    {
        angle_1 = angle_0 + 0.78539818525314331f;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(_S65 > _S64)
    {
        angle_1 = 1.57079637050628662f - angle_1;
    }
    if(x_3 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(y_2 < 0.0f)
    {
        above_0 = - angle_1;
    }
    else
    {
        above_0 = angle_1;
    }
    return above_0;
}

fn map_place_0( map_0 : u32,  direction_2 : vec3<f32>) -> vec2<f32>
{
    var _S68 : u32 = map_0 + u32(2);
    var d_0 : vec3<f32> = vector_at_0(_S68) * vec3<f32>(direction_2.x) + vector_at_0(_S68 + u32(3)) * vec3<f32>(direction_2.y) + vector_at_0(_S68 + u32(6)) * vec3<f32>(direction_2.z);
    return vec2<f32>(angle_of_0(- d_0.z, d_0.x) * 0.15915493667125702f * f32(word_0(map_0)) - 0.5f, angle_of_0(d_0.y, length(d_0.xz)) * 0.31830987334251404f * (f32(word_0(map_0 + u32(1))) - 1.0f));
}

fn in_map_0( map_1 : u32,  direction_3 : vec3<f32>) -> Lookup_0
{
    var place_5 : vec2<f32> = map_place_0(map_1, direction_3);
    var point_0 : Point_0;
    point_0.value_2 = place_5;
    var x_4 : i32 = floor_of_0(place_5.x);
    var y_3 : i32 = floor_of_0(place_5.y);
    var width_1 : i32 = i32(word_0(map_1));
    var height_1 : i32 = i32(word_0(map_1 + u32(1)));
    var left_1 : u32 = wrapped_0(x_4, width_1, u32(0));
    var right_1 : u32 = wrapped_0(x_4 + i32(1), width_1, u32(0));
    var _S69 : u32 = wrapped_0(y_3, height_1, u32(2));
    var _S70 : u32 = u32(width_1);
    var first_2 : u32 = _S69 * _S70;
    var _S71 : u32 = wrapped_0(y_3 + i32(1), height_1, u32(2));
    var second_1 : u32 = _S71 * _S70;
    return between_0(vec4<u32>(first_2 + left_1, first_2 + right_1, second_1 + left_1, second_1 + right_1), point_0);
}

fn emitted_0( emitter_2 : u32,  place_6 : Place_0,  direction_4 : vec3<f32>) -> vec3<f32>
{
    var record_2 : u32 = emitter_record_0(emitter_2);
    var texture_5 : u32 = word_0(record_2 + u32(1));
    if(!is_map_0(record_2))
    {
        var _S72 : vec3<f32> = shown_0(texture_5, place_6);
        return _S72;
    }
    var change_1 : vec2<f32> = vec2<f32>(0.0f);
    var factor_0 : vec3<f32> = looked_up_0(word_0(texture_5 + u32(12)), one_texel_0(u32(0)), change_1);
    var _S73 : u32 = word_0(texture_5 + u32(11));
    var _S74 : Lookup_0 = in_map_0(texture_5, value_of_0(direction_4));
    return looked_up_0(_S73, _S74, change_1) * factor_0;
}

fn reaches_0( segments_0 : u32) -> bool
{
    return segments_0 <= (word_0(u32(0)));
}

struct Path_0
{
     throughput_0 : vec3<f32>,
     direction_5 : vec3<f32>,
     place_7 : Place_0,
     key_0 : vec2<u32>,
     light_0 : vec3<f32>,
};

fn begin_0( number_of_path_0 : u32,  path_0 : ptr<function, Path_0>) -> bool
{
    var at_9 : u32 = u32(9) * number_of_path_0;
    var origin_2 : vec3<f32> = (bitcast<vec3<f32>>((vec3<u32>(input_0[at_9], input_0[at_9 + u32(1)], input_0[at_9 + u32(2)]))));
    var direction_6 : vec3<f32> = (bitcast<vec3<f32>>((vec3<u32>(input_0[at_9 + u32(3)], input_0[at_9 + u32(4)], input_0[at_9 + u32(5)]))));
    (*path_0).key_0 = vec2<u32>(input_0[at_9 + u32(7)], input_0[at_9 + u32(8)]);
    (*path_0).throughput_0 = still_0(vec3<f32>(1.0f));
    var t_4 : f32 = 0.0f;
    var length_of_ray_0 : f32 = (bitcast<f32>((input_0[at_9 + u32(6)])));
    var found_4 : Found_0;
    found_4.face_1 = u32(4294967295);
    found_4.triangle_1 = u32(0);
    found_4.v_3 = 0.0lf;
    found_4.w_2 = 0.0lf;
    var _S75 : bool;
    if(length_of_ray_0 >= 0.0f)
    {
        _S75 = (word_0(u32(13))) != u32(0);
    }
    else
    {
        _S75 = false;
    }
    if(_S75)
    {
        found_4 = cast_0(vec3<f64>(origin_2), vec3<f64>(direction_6), 0.0lf, f64(length_of_ray_0), false, &(t_4));
    }
    var _S76 : Place_0 = place_of_0(found_4);
    (*path_0).place_7 = _S76;
    (*path_0).direction_5 = direction_6;
    var _S77 : vec3<f32> = still_0(vec3<f32>(0.0f));
    var emitter_3 : u32 = emitter_seen_0(found_4, direction_6);
    if(emitter_3 != u32(4294967295))
    {
        _S75 = (word_0(u32(4))) != u32(0);
    }
    else
    {
        _S75 = false;
    }
    var light_1 : vec3<f32>;
    if(_S75)
    {
        var _S78 : vec3<f32> = emitted_0(emitter_3, _S76, (*path_0).direction_5);
        light_1 = _S78;
    }
    else
    {
        light_1 = _S77;
    }
    (*path_0).light_0 = light_1;
    if((found_4.face_1) != u32(4294967295))
    {
        _S75 = reaches_0(u32(2));
    }
    else
    {
        _S75 = false;
    }
    return _S75;
}

fn set_word_0( path_1 : u32,  which_1 : u32,  value_5 : u32)
{
    paths_0[which_1 * launch_0.room_0 + path_1] = value_5;
    return;
}

fn set_vector_0( path_2 : u32,  which_2 : ptr<function, u32>,  value_6 : vec3<f32>)
{
    var axis_3 : u32 = u32(0);
    for(;;)
    {
        if(axis_3 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_2, (*which_2) + axis_3, (bitcast<u32>((value_6[axis_3]))));
        axis_3 = axis_3 + u32(1);
    }
    (*which_2) = (*which_2) + u32(3);
    return;
}

fn set_changing_0( path_3 : u32,  which_3 : ptr<function, u32>,  vector_1 : vec3<f32>)
{
    set_vector_0(path_3, &((*which_3)), value_of_0(vector_1));
    return;
}

fn set_place_0( path_4 : u32,  which_4 : ptr<function, u32>,  place_8 : Place_0)
{
    set_word_0(path_4, (*which_4), place_8.triangle_2);
    set_word_0(path_4, (*which_4) + u32(1), (bitcast<u32>((place_8.v_4))));
    set_word_0(path_4, (*which_4) + u32(2), (bitcast<u32>((place_8.w_3))));
    set_word_0(path_4, (*which_4) + u32(3), (bitcast<u32>((place_8.v_rest_0))));
    set_word_0(path_4, (*which_4) + u32(4), (bitcast<u32>((place_8.w_rest_0))));
    (*which_4) = (*which_4) + u32(5);
    return;
}

fn store_0( number_of_path_1 : u32,  path_5 : Path_0)
{
    var at_10 : u32 = u32(1);
    set_changing_0(number_of_path_1, &(at_10), path_5.light_0);
    set_changing_0(number_of_path_1, &(at_10), path_5.throughput_0);
    set_changing_0(number_of_path_1, &(at_10), path_5.direction_5);
    set_place_0(number_of_path_1, &(at_10), path_5.place_7);
    set_word_0(number_of_path_1, at_10, path_5.key_0.x);
    set_word_0(number_of_path_1, at_10 + u32(1), path_5.key_0.y);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S79 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S80 : u32 = u32(2) + zero_0;
        _S79 = _S80;
        if(rounds_0 < _S80)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S79;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S81 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn begin_paths(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var number_of_path_2 : u32 = launch_0.first_0 + thread_0.x;
    if(number_of_path_2 >= (launch_0.end_0))
    {
        return;
    }
    var path_6 : Path_0;
    var goes_on_0 : bool = begin_0(number_of_path_2, &(path_6));
    store_0(number_of_path_2, path_6);
    var _S82 : u32;
    if(goes_on_0)
    {
        _S82 = number_of_path_2;
    }
    else
    {
        _S82 = u32(4294967295);
    }
    set_word_0(number_of_path_2, u32(0), _S82);
    check_loops_0();
    return;
}
