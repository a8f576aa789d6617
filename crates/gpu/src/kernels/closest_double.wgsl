// Compiled from queries.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: 4d0f77661657a545
// result: b9833ee8c0c6dd4c

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) capacity_0 : u32,
    @align(4) primitives_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(4) @group(0) var<storage, read> views_0 : array<vec4<u32>>;

@binding(5) @group(0) var<storage, read> queries_0 : array<f64>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(3) @group(0) var<storage, read> rough_0 : array<vec4<u32>>;

@binding(2) @group(0) var<storage, read> primitives_1 : array<f64>;

@binding(6) @group(0) var<storage, read_write> answers_0 : array<u32>;

@binding(7) @group(0) var<storage, read_write> values_0 : array<f64>;

fn cone_query_0( thread_0 : u32) -> u32
{
    return min(launch_0.first_0 + thread_0 / u32(8), launch_0.end_0 - u32(1));
}

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

fn query_vector_0( at_0 : u32) -> vec3<f64>
{
    return vec3<f64>(queries_0[at_0], queries_0[at_0 + u32(1)], queries_0[at_0 + u32(2)]);
}

struct Cone_0
{
     apex_1 : vec3<f64>,
     axis_1 : vec3<f64>,
     plane_point_0 : vec3<f64>,
     plane_normal_0 : vec3<f64>,
     on_plane_0 : f64,
     size_0 : f64,
     limit_1 : f64,
     largest_0 : f64,
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
    cone_0.largest_0 = queries_0[at_1 + u32(15)];
    cone_0.all_edges_1 = all_edges_2;
    return cone_0;
}

struct Nearest_0
{
     t_0 : f64,
     sin_0 : f64,
     cos_0 : f64,
     position_0 : vec3<f64>,
};

fn at_point_0( cone_1 : Cone_0,  t_1 : f64,  position_1 : vec3<f64>) -> Nearest_0
{
    var nearest_0 : Nearest_0;
    nearest_0.t_0 = t_1;
    nearest_0.position_0 = position_1;
    var across_0 : vec3<f64> = cross(cone_1.axis_1, position_1);
    nearest_0.sin_0 = sqrt(dot(across_0, across_0));
    nearest_0.cos_0 = dot(cone_1.axis_1, position_1);
    return nearest_0;
}

fn is_asked_0( thread_1 : u32) -> bool
{
    return (launch_0.first_0 + thread_1 / u32(8)) < (launch_0.end_0);
}

var<private> _S2 : u32;

fn lane_0() -> u32
{
    ;
    return (_S2 & (u32(7)));
}

struct Box_0
{
     first_1 : vec3<f32>,
     second_0 : vec3<f32>,
     third_0 : vec3<f32>,
     half_size_0 : vec3<f32>,
};

fn reach_0( box_0 : Box_0,  v_0 : vec3<f32>) -> f32
{
    return abs(dot(box_0.first_1, v_0)) * box_0.half_size_0.x + abs(dot(box_0.second_0, v_0)) * box_0.half_size_0.y + abs(dot(box_0.third_0, v_0)) * box_0.half_size_0.z;
}

fn child_bound_0( view_1 : ConeView_0,  limit_2 : f32,  node_0 : u32,  slot_0 : u32) -> f32
{
    var at_2 : u32 = u32(32) * node_0 + slot_0;
    var a_1 : vec4<u32> = nodes_0[at_2];
    var b_1 : vec4<u32> = nodes_0[at_2 + u32(8)];
    var c_1 : vec4<u32> = nodes_0[at_2 + u32(16)];
    var d_0 : vec4<u32> = nodes_0[at_2 + u32(24)];
    if((((d_0.w) & ((view_1.groups_0)))) == u32(0))
    {
        return 3.00000000549775576e+38f;
    }
    var centre_0 : vec3<f32> = (bitcast<vec3<f32>>((a_1.xyz))) - view_1.apex_0;
    var box_1 : Box_0;
    var _S3 : vec3<f32> = (bitcast<vec3<f32>>((b_1.xyz)));
    box_1.first_1 = _S3;
    var _S4 : vec3<f32> = (bitcast<vec3<f32>>((c_1.xyz)));
    box_1.second_0 = _S4;
    box_1.third_0 = cross(_S3, _S4);
    box_1.half_size_0 = vec3<f32>((bitcast<f32>((b_1.w))), (bitcast<f32>((c_1.w))), (bitcast<f32>((d_0.y))));
    var has_tangent_0 : bool;
    if(!view_1.all_edges_0)
    {
        var clearance_0 : f32 = abs(dot(box_1.first_1, centre_0)) - (bitcast<f32>((d_0.x))) - view_1.plane_margin_0;
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
    var _S5 : f32 = max(dot(radial_0, radial_0), 1.00000000317107685e-30f);
    if(!(_S5 < 9.99999993381581251e+36f))
    {
        return 0.0f;
    }
    var distance_0 : f32 = sqrt(_S5);
    var _S6 : bool = limit_2 < 1.0f;
    var tangent_0 : f32;
    if(_S6)
    {
        tangent_0 = limit_2 / max(1.0f - limit_2, 9.99999997475242708e-07f);
    }
    else
    {
        tangent_0 = 8.0f;
    }
    if(_S6)
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
        slope_0 = min(_S5 / z_0, limit_slope_0);
    }
    else
    {
        slope_0 = limit_slope_0;
    }
    var _S7 : f32 = distance_0 + any_reach_0;
    var at_zero_0 : f32 = _S5 - reach_0(box_1, radial_0) - view_1.margin_0 * _S7;
    var at_slope_0 : f32 = _S5 - slope_0 * z_0 - reach_0(box_1, radial_0 - view_1.axis_0 * vec3<f32>(slope_0)) - view_1.margin_0 * (distance_0 + slope_0 + any_reach_0);
    var _S8 : bool;
    if(at_slope_0 > 0.0f)
    {
        _S8 = limit_slope_0 <= slope_0;
    }
    else
    {
        _S8 = false;
    }
    if(_S8)
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
        bound_0 = 1.0f - highest_0 / (_S7 + view_1.margin_0 - highest_0);
    }
    else
    {
        var _S9 : f32 = max(at_zero_0, 0.0f);
        var in_front_0 : f32 = slope_0 / distance_0 * _S9;
        var sum_0 : f32 = _S9 - min(at_slope_0, 0.0f) + in_front_0;
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

fn cone_child_0( node_1 : u32,  slot_1 : u32) -> u32
{
    return nodes_0[u32(32) * node_1 + slot_1 + u32(24)].z;
}

fn own_child_0( view_2 : ConeView_0,  limit_3 : f32,  node_2 : u32) -> vec2<u32>
{
    var slot_2 : u32 = lane_0();
    var bound_1 : f32 = child_bound_0(view_2, limit_3, node_2, slot_2);
    var _S10 : u32;
    if(bound_1 > limit_3)
    {
        _S10 = u32(4294967295);
    }
    else
    {
        _S10 = ((((bitcast<u32>((bound_1))) & (u32(4294967288)))) | (slot_2));
    }
    return vec2<u32>(_S10, cone_child_0(node_2, slot_2));
}

struct Way_0
{
     levels_0 : array<vec2<u32>, i32(40)>,
     here_0 : vec2<u32>,
     level_0 : u32,
     child_0 : u32,
     is_over_0 : bool,
};

fn start_0( view_3 : ConeView_0,  is_asked_1 : bool) -> Way_0
{
    var way_0 : Way_0;
    var _S11 : bool;
    if(!is_asked_1)
    {
        _S11 = true;
    }
    else
    {
        _S11 = !((view_3.limit_0) >= 0.0f);
    }
    way_0.is_over_0 = _S11;
    var _S12 : vec2<u32>;
    if(_S11)
    {
        _S12 = vec2<u32>(u32(4294967295), u32(4294967295));
    }
    else
    {
        var _S13 : vec2<u32> = own_child_0(view_3, view_3.limit_0, u32(0));
        _S12 = _S13;
    }
    way_0.here_0 = _S12;
    way_0.levels_0[i32(0)] = _S12;
    way_0.level_0 = u32(0);
    way_0.child_0 = u32(4294967295);
    return way_0;
}

fn any_in_step_0( condition_0 : bool) -> bool
{
    var _S14 : bool = subgroupAny(condition_0);
    return _S14;
}

fn of_lane_0( value_0 : u32,  other_0 : u32) -> u32
{
    ;
    var _S15 : u32 = subgroupShuffle(value_0, u32((((_S2 & (u32(4294967288)))) | (other_0))));
    return _S15;
}

fn least_0( value_1 : u32) -> u32
{
    var _S16 : u32 = lane_0();
    var _S17 : u32 = of_lane_0(value_1, (_S16 ^ (u32(1))));
    var _S18 : u32 = min(value_1, _S17);
    var _S19 : u32 = lane_0();
    var _S20 : u32 = of_lane_0(_S18, (_S19 ^ (u32(2))));
    var _S21 : u32 = min(_S18, _S20);
    var _S22 : u32 = lane_0();
    var _S23 : u32 = of_lane_0(_S21, (_S22 ^ (u32(4))));
    return min(_S21, _S23);
}

fn reach_leaf_0( way_1 : ptr<function, Way_0>,  view_4 : ConeView_0,  limit_4 : f32) -> bool
{
    for(;;)
    {
        var _S24 : bool;
        if(!(*way_1).is_over_0)
        {
            _S24 = ((*way_1).child_0) == u32(4294967295);
        }
        else
        {
            _S24 = false;
        }
        var _S25 : bool = any_in_step_0(_S24);
        if(_S25)
        {
        }
        else
        {
            break;
        }
        var is_moving_0 : bool;
        if(!(*way_1).is_over_0)
        {
            is_moving_0 = ((*way_1).child_0) == u32(4294967295);
        }
        else
        {
            is_moving_0 = false;
        }
        var nearest_1 : u32 = least_0((*way_1).here_0.x);
        var is_done_0 : bool = nearest_1 > (((bitcast<u32>((limit_4))) | (u32(7))));
        var _S26 : u32 = (nearest_1 & (u32(7)));
        var child_1 : u32 = of_lane_0((*way_1).here_0.y, _S26);
        var _S27 : bool;
        if(is_moving_0)
        {
            _S27 = is_done_0;
        }
        else
        {
            _S27 = false;
        }
        if(_S27)
        {
            var _S28 : bool = ((*way_1).level_0) == u32(0);
            (*way_1).is_over_0 = _S28;
            if(!_S28)
            {
                var _S29 : u32 = (*way_1).level_0 - u32(1);
                (*way_1).level_0 = _S29;
                (*way_1).here_0 = (*way_1).levels_0[_S29];
            }
        }
        else
        {
            if(is_moving_0)
            {
                var _S30 : u32 = lane_0();
                if(_S30 == _S26)
                {
                    (*way_1).here_0[i32(0)] = u32(4294967295);
                }
                if(((child_1 & (u32(2147483648)))) != u32(0))
                {
                    (*way_1).child_0 = child_1;
                }
                else
                {
                    (*way_1).levels_0[(*way_1).level_0] = (*way_1).here_0;
                    (*way_1).level_0 = (*way_1).level_0 + u32(1);
                    var _S31 : vec2<u32> = own_child_0(view_4, limit_4, child_1);
                    (*way_1).here_0 = _S31;
                }
            }
        }
    }
    var _S32 : bool = any_in_step_0(!(*way_1).is_over_0);
    return _S32;
}

fn sum_of_sizes_0( v_1 : vec3<f32>) -> f32
{
    return abs(v_1.x) + abs(v_1.y) + abs(v_1.z);
}

fn may_count_0( view_5 : ConeView_0,  limit_5 : f32,  edge_0 : u32,  number_0 : ptr<function, u32>) -> bool
{
    var a_2 : vec4<u32> = rough_0[edge_0];
    var b_2 : vec4<u32> = rough_0[launch_0.primitives_0 + edge_0];
    (*number_0) = b_2.w;
    if((((a_2.w) & ((view_5.groups_0)))) == u32(0))
    {
        return false;
    }
    var start_1 : vec3<f32> = (bitcast<vec3<f32>>((a_2.xyz))) - view_5.apex_0;
    var along_0 : vec3<f32> = (bitcast<vec3<f32>>((b_2.xyz)));
    if(!view_5.all_edges_0)
    {
        var first_2 : f32 = dot((bitcast<vec3<f32>>((rough_0[u32(2) * launch_0.primitives_0 + edge_0].xyz))), start_1);
        var second_1 : f32 = dot((bitcast<vec3<f32>>((rough_0[u32(3) * launch_0.primitives_0 + edge_0].xyz))), start_1);
        var _S33 : bool;
        if((min(first_2, second_1)) > (view_5.plane_margin_0))
        {
            _S33 = true;
        }
        else
        {
            _S33 = (max(first_2, second_1)) < (- view_5.plane_margin_0);
        }
        if(_S33)
        {
            return false;
        }
    }
    var tangent_1 : f32;
    if(limit_5 < 1.0f)
    {
        tangent_1 = limit_5 / max(1.0f - limit_5, 9.99999997475242708e-07f) * 1.0009765625f;
    }
    else
    {
        tangent_1 = 3.00000000549775576e+38f;
    }
    if(tangent_1 > 8.0f)
    {
        return true;
    }
    var middle_0 : vec3<f32> = start_1 + vec3<f32>(0.5f) * along_0;
    var z_1 : f32 = dot(view_5.axis_0, middle_0);
    var radial_1 : vec3<f32> = middle_0 - view_5.axis_0 * vec3<f32>(z_1);
    var _S34 : f32 = max(dot(radial_1, radial_1), 1.00000000317107685e-30f);
    if(!(_S34 < 9.99999993381581251e+36f))
    {
        return true;
    }
    var distance_1 : f32 = sqrt(_S34);
    var slope_1 : f32 = distance_1 * tangent_1;
    return (_S34 - slope_1 * z_1 - 0.5f * abs(dot(radial_1 - view_5.axis_0 * vec3<f32>(slope_1), along_0))) <= (view_5.margin_0 * (distance_1 + slope_1 + sum_of_sizes_0(along_0)));
}

fn primitive_vector_0( at_3 : u32) -> vec3<f64>
{
    return vec3<f64>(primitives_1[at_3], primitives_1[at_3 + u32(1)], primitives_1[at_3 + u32(2)]);
}

fn sum_of_sizes_1( v_2 : vec3<f64>) -> f64
{
    return abs(v_2.x) + abs(v_2.y) + abs(v_2.z);
}

fn side_seen_0( cone_2 : Cone_0,  from_0 : vec3<f64>,  size_1 : f64,  normal_0 : vec3<f64>,  length_0 : f64) -> i32
{
    var height_0 : f64 = dot(normal_0, from_0);
    var tolerance_0 : f64 = cone_2.on_plane_0 * size_1 * length_0;
    var _S35 : i32;
    if(height_0 > tolerance_0)
    {
        _S35 = i32(1);
    }
    else
    {
        _S35 = i32(0);
    }
    var _S36 : i32;
    if(height_0 < (- tolerance_0))
    {
        _S36 = i32(1);
    }
    else
    {
        _S36 = i32(0);
    }
    return _S35 - _S36;
}

fn beyond_0() -> f64
{
    return 4.0lf;
}

fn rounded_0( product_0 : f64,  largest_1 : f64) -> f64
{
    return min(product_0, largest_1);
}

fn exact_cross_0( a_3 : vec3<f64>,  b_3 : vec3<f64>,  largest_2 : f64) -> vec3<f64>
{
    var _S37 : f64 = a_3.y;
    var _S38 : f64 = b_3.z;
    var _S39 : f64 = a_3.z;
    var _S40 : f64 = b_3.y;
    var _S41 : f64 = b_3.x;
    var _S42 : f64 = a_3.x;
    return vec3<f64>(rounded_0(_S37 * _S38, largest_2) - rounded_0(_S39 * _S40, largest_2), rounded_0(_S39 * _S41, largest_2) - rounded_0(_S42 * _S38, largest_2), rounded_0(_S42 * _S40, largest_2) - rounded_0(_S37 * _S41, largest_2));
}

fn is_nearer_0( p_0 : Nearest_0,  q_0 : Nearest_0) -> bool
{
    return (p_0.sin_0 * q_0.cos_0) < (q_0.sin_0 * p_0.cos_0);
}

fn closest_on_edge_0( cone_3 : Cone_0,  at_4 : u32,  nearest_2 : ptr<function, Nearest_0>) -> f64
{
    (*nearest_2) = at_point_0(cone_3, 0.0lf, cone_3.axis_1);
    var start_2 : vec3<f64> = primitive_vector_0(at_4);
    var a_4 : vec3<f64> = start_2 - cone_3.apex_1;
    var finish_0 : vec3<f64> = primitive_vector_0(at_4 + u32(3));
    var b_4 : vec3<f64> = finish_0 - cone_3.apex_1;
    var along_1 : vec3<f64> = b_4 - a_4;
    if(!cone_3.all_edges_1)
    {
        var size_2 : f64 = cone_3.size_0 + sum_of_sizes_1(start_2);
        var from_1 : vec3<f64> = cone_3.apex_1 - start_2;
        if((side_seen_0(cone_3, from_1, size_2, primitive_vector_0(at_4 + u32(6)), primitives_1[at_4 + u32(12)]) * side_seen_0(cone_3, from_1, size_2, primitive_vector_0(at_4 + u32(9)), primitives_1[at_4 + u32(13)])) > i32(0))
        {
            return beyond_0();
        }
    }
    var _S43 : bool;
    if((dot(start_2 - cone_3.plane_point_0, cone_3.plane_normal_0)) < 0.0lf)
    {
        _S43 = (dot(finish_0 - cone_3.plane_point_0, cone_3.plane_normal_0)) < 0.0lf;
    }
    else
    {
        _S43 = false;
    }
    if(_S43)
    {
        return beyond_0();
    }
    var normal_1 : vec3<f64> = exact_cross_0(a_4, along_1, cone_3.largest_0);
    if((normal_1.x) == 0.0lf)
    {
        _S43 = (normal_1.y) == 0.0lf;
    }
    else
    {
        _S43 = false;
    }
    if(_S43)
    {
        _S43 = (normal_1.z) == 0.0lf;
    }
    else
    {
        _S43 = false;
    }
    if(_S43)
    {
        _S43 = (dot(a_4, b_4)) <= 0.0lf;
    }
    else
    {
        _S43 = false;
    }
    if(_S43)
    {
        return beyond_0();
    }
    var _S44 : Nearest_0 = at_point_0(cone_3, 0.0lf, a_4);
    (*nearest_2) = _S44;
    var other_1 : Nearest_0 = at_point_0(cone_3, 1.0lf, b_4);
    if(is_nearer_0(other_1, _S44))
    {
        (*nearest_2) = other_1;
    }
    var w_0 : vec3<f64> = cross(cone_3.axis_1, normal_1);
    var falls_0 : f64 = dot(along_1, w_0);
    if(falls_0 != 0.0lf)
    {
        var t_2 : f64 = - dot(a_4, w_0) / falls_0;
        if(t_2 > 0.0lf)
        {
            _S43 = t_2 < 1.0lf;
        }
        else
        {
            _S43 = false;
        }
        if(_S43)
        {
            var other_2 : Nearest_0 = at_point_0(cone_3, t_2, a_4 + along_1 * vec3<f64>(t_2));
            if(is_nearer_0(other_2, (*nearest_2)))
            {
                (*nearest_2) = other_2;
            }
        }
    }
    var total_0 : f64 = (*nearest_2).sin_0 + abs((*nearest_2).cos_0);
    if(!(total_0 > 0.0lf))
    {
        return beyond_0();
    }
    var _S45 : f64;
    if(((*nearest_2).cos_0) >= 0.0lf)
    {
        _S45 = (*nearest_2).sin_0 / total_0;
    }
    else
    {
        _S45 = 1.0lf - (*nearest_2).cos_0 / total_0;
    }
    return _S45;
}

fn real_of_lane_0( value_2 : f64,  other_3 : u32) -> f64
{
    ;
    var _S46 : f64 = subgroupShuffle(value_2, u32((((_S2 & (u32(4294967288)))) | (other_3))));
    return _S46;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S47 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S48 : u32 = u32(2) + zero_0;
        _S47 = _S48;
        if(rounds_0 < _S48)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S47;
}

fn is_cut_short_0() -> bool
{
    return !loops_end_0(((launch_0.end_0) >> (u32(31))));
}

@compute
@workgroup_size(64, 1, 1)
fn closest(@builtin(global_invocation_id) thread_2 : vec3<u32>, @builtin(subgroup_invocation_id) _builtinWaveLaneIndex_0 : u32)
{
    var found_0 : u32;
    var i_0 : u32;
    var _S49 : bool;
    var _S50 : bool;
    _S2 = _builtinWaveLaneIndex_0;
    var _S51 : u32 = thread_2.x;
    var query_2 : u32 = cone_query_0(_S51);
    var view_6 : ConeView_0 = cone_view_0(query_2);
    var _S52 : Cone_0 = cone_at_0(query_2, view_6.all_edges_0);
    var cone_4 : Cone_0 = _S52;
    var _S53 : Nearest_0 = at_point_0(_S52, 0.0lf, cone_4.axis_1);
    var _S54 : bool = is_asked_0(_S51);
    var _S55 : Way_0 = start_0(view_6, _S54);
    var way_2 : Way_0 = _S55;
    var limit_6 : f32 = view_6.limit_0;
    var found_1 : u32 = u32(4294967295);
    var best_0 : Nearest_0 = _S53;
    for(;;)
    {
        var _S56 : bool = reach_leaf_0(&(way_2), view_6, limit_6);
        if(_S56)
        {
        }
        else
        {
            break;
        }
        var limit_7 : f32;
        var best_1 : Nearest_0;
        if(!way_2.is_over_0)
        {
            var leaf_0 : u32 = ((way_2.child_0) & (u32(2147483647)));
            var _S57 : u32 = leaf_starts_0[leaf_0 + u32(1)];
            way_2.child_0 = u32(4294967295);
            var _S58 : u32 = leaf_starts_0[leaf_0];
            var _S59 : u32 = lane_0();
            var _S60 : u32 = _S58 + _S59;
            limit_7 = limit_6;
            found_0 = found_1;
            best_1 = best_0;
            i_0 = _S60;
            for(;;)
            {
                if(i_0 < _S57)
                {
                }
                else
                {
                    break;
                }
                var edge_1 : u32;
                var _S61 : bool = may_count_0(view_6, limit_7, i_0, &(edge_1));
                if(!_S61)
                {
                    i_0 = i_0 + u32(8);
                    continue;
                }
                var nearest_3 : Nearest_0;
                var angle_0 : f64 = closest_on_edge_0(cone_4, u32(14) * i_0, &(nearest_3));
                if(angle_0 < (cone_4.limit_1))
                {
                    _S49 = true;
                }
                else
                {
                    if(angle_0 == (cone_4.limit_1))
                    {
                        _S49 = found_0 != u32(4294967295);
                    }
                    else
                    {
                        _S49 = false;
                    }
                    if(_S49)
                    {
                        _S50 = edge_1 < found_0;
                    }
                    else
                    {
                        _S50 = false;
                    }
                    _S49 = _S50;
                }
                var limit_8 : f32;
                var found_2 : u32;
                var best_2 : Nearest_0;
                if(_S49)
                {
                    cone_4.limit_1 = angle_0;
                    limit_8 = min(limit_7, f32(angle_0) * 1.0009765625f);
                    found_2 = edge_1;
                    best_2 = nearest_3;
                }
                else
                {
                    limit_8 = limit_7;
                    found_2 = found_0;
                    best_2 = best_1;
                }
                limit_7 = limit_8;
                found_0 = found_2;
                best_1 = best_2;
                i_0 = i_0 + u32(8);
            }
        }
        else
        {
            limit_7 = limit_6;
            found_0 = found_1;
            best_1 = best_0;
        }
        var _S62 : u32 = least_0((bitcast<u32>((limit_7))));
        limit_6 = (bitcast<f32>((_S62)));
        found_1 = found_0;
        best_0 = best_1;
    }
    found_0 = found_1;
    var angle_1 : f64 = cone_4.limit_1;
    i_0 = u32(1);
    for(;;)
    {
        if(i_0 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S63 : u32 = lane_0();
        var other_4 : u32 = of_lane_0(found_0, (_S63 ^ (i_0)));
        var _S64 : u32 = lane_0();
        var its_0 : f64 = real_of_lane_0(angle_1, (_S64 ^ (i_0)));
        if(other_4 != u32(4294967295))
        {
            if(found_0 == u32(4294967295))
            {
                _S49 = true;
            }
            else
            {
                _S49 = its_0 < angle_1;
            }
            if(_S49)
            {
                _S50 = true;
            }
            else
            {
                if(its_0 == angle_1)
                {
                    _S50 = other_4 < found_0;
                }
                else
                {
                    _S50 = false;
                }
            }
            _S49 = _S50;
        }
        else
        {
            _S49 = false;
        }
        if(_S49)
        {
            found_0 = other_4;
            angle_1 = its_0;
        }
        i_0 = i_0 * u32(2);
    }
    var is_cut_0 : bool = is_cut_short_0();
    if(is_cut_0)
    {
        _S49 = _S54;
    }
    else
    {
        _S49 = false;
    }
    if(_S49)
    {
        answers_0[query_2] = u32(4294967294);
    }
    if(is_cut_0)
    {
        _S49 = true;
    }
    else
    {
        _S49 = !_S54;
    }
    if(_S49)
    {
        _S49 = true;
    }
    else
    {
        _S49 = found_1 != found_0;
    }
    if(_S49)
    {
        _S49 = true;
    }
    else
    {
        if(found_0 == u32(4294967295))
        {
            var _S65 : u32 = lane_0();
            _S49 = _S65 != u32(0);
        }
        else
        {
            _S49 = false;
        }
    }
    if(_S49)
    {
        return;
    }
    answers_0[query_2] = found_1;
    var _S66 : u32 = u32(4) * query_2;
    values_0[_S66] = best_0.t_0;
    values_0[_S66 + u32(1)] = best_0.position_0.x;
    values_0[_S66 + u32(2)] = best_0.position_0.y;
    values_0[_S66 + u32(3)] = best_0.position_0.z;
    return;
}
