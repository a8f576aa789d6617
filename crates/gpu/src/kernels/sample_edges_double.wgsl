// Compiled from sampled.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: b523b92d31fc77e2
// result: 298f7ff1f58bdbc3

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

@binding(2) @group(0) var<storage, read> primitives_1 : array<f64>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(6) @group(0) var<storage, read_write> answers_0 : array<u32>;

@binding(7) @group(0) var<storage, read_write> values_0 : array<f64>;

fn query_vector_0( at_0 : u32) -> vec3<f64>
{
    return vec3<f64>(queries_0[at_0], queries_0[at_0 + u32(1)], queries_0[at_0 + u32(2)]);
}

struct Number_0
{
     value_0 : f64,
};

fn number_at_0( query_0 : u32,  i_0 : u32) -> Number_0
{
    var number_0 : Number_0;
    number_0.value_0 = queries_0[u32(22) * query_0 + u32(16) + u32(4) + i_0];
    return number_0;
}

fn primitive_vector_0( at_1 : u32) -> vec3<f64>
{
    return vec3<f64>(primitives_1[at_1], primitives_1[at_1 + u32(1)], primitives_1[at_1 + u32(2)]);
}

fn bound_0( node_0 : u32,  i_1 : u32) -> f64
{
    return primitives_1[u32(36) * node_0 + i_1];
}

fn sum_of_sizes_0( v_0 : vec3<f64>) -> f64
{
    return abs(v_0.x) + abs(v_0.y) + abs(v_0.z);
}

struct Cone_0
{
     apex_0 : vec3<f64>,
     axis_0 : vec3<f64>,
     plane_point_0 : vec3<f64>,
     plane_normal_0 : vec3<f64>,
     on_plane_0 : f64,
     size_0 : f64,
     limit_0 : f64,
     largest_0 : f64,
     all_edges_0 : bool,
};

struct Sampled_0
{
     cone_0 : Cone_0,
     sin_0 : f64,
     cos_0 : f64,
     clear_0 : f64,
     size_1 : f64,
};

fn clear_of_0( sampled_0 : Sampled_0,  node_1 : u32) -> f64
{
    var radius_0 : f64 = bound_0(node_1, u32(3));
    return sampled_0.clear_0 * (sampled_0.size_1 + sum_of_sizes_0(primitive_vector_0(u32(36) * node_1)) + (radius_0 + radius_0));
}

fn may_have_silhouette_0( sampled_1 : Sampled_0,  node_2 : u32,  offset_0 : vec3<f64>,  distance_0 : f64) -> bool
{
    var sin_1 : f64 = bound_0(node_2, u32(7));
    var cos_1 : f64 = bound_0(node_2, u32(8));
    if(sin_1 > 1.0lf)
    {
        return true;
    }
    var clear_1 : f64 = clear_of_0(sampled_1, node_2);
    var margin_0 : f64 = (bound_0(node_2, u32(3)) + clear_1) * cos_1;
    var margin_1 : f64;
    if(cos_1 > 0.0lf)
    {
        margin_1 = min((bound_0(node_2, u32(9)) + clear_1) / cos_1, margin_0);
    }
    else
    {
        margin_1 = margin_0;
    }
    return !((abs(dot(primitive_vector_0(u32(36) * node_2 + u32(4)), offset_0))) > (sin_1 * distance_0 + margin_1 + clear_1));
}

fn is_beside_0( sampled_2 : Sampled_0,  node_3 : u32,  offset_1 : vec3<f64>,  distance_1 : f64) -> bool
{
    var z_0 : f64 = dot(sampled_2.cone_0.axis_0, offset_1);
    var radial_0 : vec3<f64> = offset_1 - sampled_2.cone_0.axis_0 * vec3<f64>(z_0);
    var rho_0 : f64 = sqrt(dot(radial_0, radial_0));
    var beside_0 : f64 = rho_0 * sampled_2.cos_0 - z_0 * sampled_2.sin_0;
    var along_0 : f64 = rho_0 * sampled_2.sin_0 + z_0 * sampled_2.cos_0;
    if(beside_0 < 0.0lf)
    {
        return false;
    }
    var least_0 : f64;
    if(along_0 < 0.0lf)
    {
        least_0 = distance_1;
    }
    else
    {
        least_0 = beside_0;
    }
    return least_0 > (bound_0(node_3, u32(3)) + clear_of_0(sampled_2, node_3));
}

fn component_0( v_1 : vec3<f64>,  axis_1 : u32) -> f64
{
    var _S1 : f64;
    if(axis_1 == u32(0))
    {
        _S1 = v_1.x;
    }
    else
    {
        if(axis_1 == u32(1))
        {
            _S1 = v_1.y;
        }
        else
        {
            _S1 = v_1.z;
        }
    }
    return _S1;
}

fn direction_number_0( d_0 : vec3<f64>) -> u32
{
    var _S2 : f64 = d_0.y;
    var _S3 : f64 = d_0.x;
    var _S4 : i32;
    if((abs(_S2)) > (abs(_S3)))
    {
        _S4 = i32(1);
    }
    else
    {
        _S4 = i32(0);
    }
    var axis_2 : u32 = u32(_S4);
    var _S5 : f64 = abs(d_0.z);
    var _S6 : f64;
    if(axis_2 == u32(0))
    {
        _S6 = _S3;
    }
    else
    {
        _S6 = _S2;
    }
    var axis_3 : u32;
    if(_S5 > (abs(_S6)))
    {
        axis_3 = u32(2);
    }
    else
    {
        axis_3 = axis_2;
    }
    var next_0 : u32 = (axis_3 + u32(1)) % u32(3);
    var last_0 : u32 = (axis_3 + u32(2)) % u32(3);
    var _S7 : u32 = u32(8) * axis_3;
    if((component_0(d_0, axis_3)) < 0.0lf)
    {
        _S4 = i32(4);
    }
    else
    {
        _S4 = i32(0);
    }
    var _S8 : u32 = _S7 + u32(_S4);
    if((component_0(d_0, next_0)) < 0.0lf)
    {
        _S4 = i32(2);
    }
    else
    {
        _S4 = i32(0);
    }
    var _S9 : u32 = _S8 + u32(_S4);
    if((component_0(d_0, last_0)) < 0.0lf)
    {
        _S4 = i32(1);
    }
    else
    {
        _S4 = i32(0);
    }
    return _S9 + u32(_S4);
}

fn importance_0( sampled_3 : Sampled_0,  node_4 : u32) -> f64
{
    var offset_2 : vec3<f64> = primitive_vector_0(u32(36) * node_4) - sampled_3.cone_0.apex_0;
    var square_0 : f64 = dot(offset_2, offset_2);
    var distance_2 : f64 = sqrt(square_0);
    var radius_1 : f64 = bound_0(node_4, u32(3));
    var _S10 : bool;
    if(!sampled_3.cone_0.all_edges_0)
    {
        _S10 = !may_have_silhouette_0(sampled_3, node_4, offset_2, distance_2);
    }
    else
    {
        _S10 = false;
    }
    if(_S10)
    {
        return 0.0lf;
    }
    if(is_beside_0(sampled_3, node_4, offset_2, distance_2))
    {
        return 0.0lf;
    }
    var _S11 : f64 = max(square_0, radius_1 * radius_1);
    if(!(_S11 > 0.0lf))
    {
        return 0.0lf;
    }
    var length_0 : f64 = bound_0(node_4, u32(10));
    var length_1 : f64;
    if(distance_2 > (bound_0(node_4, u32(11))))
    {
        length_1 = length_0 * bound_0(node_4, u32(12) + direction_number_0((vec3<f64>(0) - offset_2)));
    }
    else
    {
        length_1 = length_0;
    }
    return length_1 / _S11;
}

fn descend_0( sampled_4 : Sampled_0,  number_1 : Number_0,  leaf_0 : ptr<function, u32>,  probability_0 : ptr<function, f64>) -> bool
{
    var _S12 : Number_0 = number_1;
    (*leaf_0) = u32(0);
    (*probability_0) = 1.0lf;
    for(;;)
    {
        if((nodes_0[(*leaf_0)].x) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var halves_0 : vec2<u32> = nodes_0[(*leaf_0)].xy;
        var _S13 : u32 = halves_0.x;
        var first_1 : f64 = importance_0(sampled_4, _S13);
        var _S14 : u32 = halves_0.y;
        var second_0 : f64 = importance_0(sampled_4, _S14);
        var sum_0 : f64 = first_1 + second_0;
        if(!(sum_0 > 0.0lf))
        {
            return false;
        }
        var first_share_0 : f64 = first_1 / sum_0;
        var second_share_0 : f64 = second_0 / sum_0;
        var is_second_0 : bool;
        if((_S12.value_0) >= first_share_0)
        {
            is_second_0 = second_share_0 > 0.0lf;
        }
        else
        {
            is_second_0 = false;
        }
        if(is_second_0)
        {
            _S12.value_0 = (_S12.value_0 - first_share_0) / second_share_0;
        }
        else
        {
            _S12.value_0 = min(_S12.value_0 / first_share_0, 1.0lf);
        }
        var _S15 : f64 = (*probability_0);
        var _S16 : f64;
        if(is_second_0)
        {
            _S16 = second_share_0;
        }
        else
        {
            _S16 = first_share_0;
        }
        (*probability_0) = _S15 * _S16;
        var _S17 : u32;
        if(is_second_0)
        {
            _S17 = _S14;
        }
        else
        {
            _S17 = _S13;
        }
        (*leaf_0) = _S17;
    }
    return true;
}

fn side_seen_0( cone_1 : Cone_0,  from_0 : vec3<f64>,  size_2 : f64,  normal_0 : vec3<f64>,  length_2 : f64) -> i32
{
    var height_0 : f64 = dot(normal_0, from_0);
    var tolerance_0 : f64 = cone_1.on_plane_0 * size_2 * length_2;
    var _S18 : i32;
    if(height_0 > tolerance_0)
    {
        _S18 = i32(1);
    }
    else
    {
        _S18 = i32(0);
    }
    var _S19 : i32;
    if(height_0 < (- tolerance_0))
    {
        _S19 = i32(1);
    }
    else
    {
        _S19 = i32(0);
    }
    return _S18 - _S19;
}

fn is_silhouette_0( cone_2 : Cone_0,  at_2 : u32) -> bool
{
    var start_0 : vec3<f64> = primitive_vector_0(at_2);
    var size_3 : f64 = cone_2.size_0 + sum_of_sizes_0(start_0);
    var from_1 : vec3<f64> = cone_2.apex_0 - start_0;
    return (side_seen_0(cone_2, from_1, size_3, primitive_vector_0(at_2 + u32(6)), primitives_1[at_2 + u32(12)]) * side_seen_0(cone_2, from_1, size_3, primitive_vector_0(at_2 + u32(9)), primitives_1[at_2 + u32(13)])) <= i32(0);
}

struct Nearest_0
{
     t_0 : f64,
     sin_2 : f64,
     cos_2 : f64,
     position_0 : vec3<f64>,
};

fn at_point_0( cone_3 : Cone_0,  t_1 : f64,  position_1 : vec3<f64>) -> Nearest_0
{
    var nearest_0 : Nearest_0;
    nearest_0.t_0 = t_1;
    nearest_0.position_0 = position_1;
    var across_0 : vec3<f64> = cross(cone_3.axis_0, position_1);
    nearest_0.sin_2 = sqrt(dot(across_0, across_0));
    nearest_0.cos_2 = dot(cone_3.axis_0, position_1);
    return nearest_0;
}

fn beyond_0() -> f64
{
    return 4.0lf;
}

fn rounded_0( product_0 : f64,  largest_1 : f64) -> f64
{
    return min(product_0, largest_1);
}

fn exact_cross_0( a_0 : vec3<f64>,  b_0 : vec3<f64>,  largest_2 : f64) -> vec3<f64>
{
    var _S20 : f64 = a_0.y;
    var _S21 : f64 = b_0.z;
    var _S22 : f64 = a_0.z;
    var _S23 : f64 = b_0.y;
    var _S24 : f64 = b_0.x;
    var _S25 : f64 = a_0.x;
    return vec3<f64>(rounded_0(_S20 * _S21, largest_2) - rounded_0(_S22 * _S23, largest_2), rounded_0(_S22 * _S24, largest_2) - rounded_0(_S25 * _S21, largest_2), rounded_0(_S25 * _S23, largest_2) - rounded_0(_S20 * _S24, largest_2));
}

fn is_nearer_0( p_0 : Nearest_0,  q_0 : Nearest_0) -> bool
{
    return (p_0.sin_2 * q_0.cos_2) < (q_0.sin_2 * p_0.cos_2);
}

fn closest_on_edge_0( cone_4 : Cone_0,  at_3 : u32,  nearest_1 : ptr<function, Nearest_0>) -> f64
{
    (*nearest_1) = at_point_0(cone_4, 0.0lf, cone_4.axis_0);
    var start_1 : vec3<f64> = primitive_vector_0(at_3);
    var a_1 : vec3<f64> = start_1 - cone_4.apex_0;
    var finish_0 : vec3<f64> = primitive_vector_0(at_3 + u32(3));
    var b_1 : vec3<f64> = finish_0 - cone_4.apex_0;
    var along_1 : vec3<f64> = b_1 - a_1;
    if(!cone_4.all_edges_0)
    {
        var size_4 : f64 = cone_4.size_0 + sum_of_sizes_0(start_1);
        var from_2 : vec3<f64> = cone_4.apex_0 - start_1;
        if((side_seen_0(cone_4, from_2, size_4, primitive_vector_0(at_3 + u32(6)), primitives_1[at_3 + u32(12)]) * side_seen_0(cone_4, from_2, size_4, primitive_vector_0(at_3 + u32(9)), primitives_1[at_3 + u32(13)])) > i32(0))
        {
            return beyond_0();
        }
    }
    var _S26 : bool;
    if((dot(start_1 - cone_4.plane_point_0, cone_4.plane_normal_0)) < 0.0lf)
    {
        _S26 = (dot(finish_0 - cone_4.plane_point_0, cone_4.plane_normal_0)) < 0.0lf;
    }
    else
    {
        _S26 = false;
    }
    if(_S26)
    {
        return beyond_0();
    }
    var normal_1 : vec3<f64> = exact_cross_0(a_1, along_1, cone_4.largest_0);
    if((normal_1.x) == 0.0lf)
    {
        _S26 = (normal_1.y) == 0.0lf;
    }
    else
    {
        _S26 = false;
    }
    if(_S26)
    {
        _S26 = (normal_1.z) == 0.0lf;
    }
    else
    {
        _S26 = false;
    }
    if(_S26)
    {
        _S26 = (dot(a_1, b_1)) <= 0.0lf;
    }
    else
    {
        _S26 = false;
    }
    if(_S26)
    {
        return beyond_0();
    }
    var _S27 : Nearest_0 = at_point_0(cone_4, 0.0lf, a_1);
    (*nearest_1) = _S27;
    var other_0 : Nearest_0 = at_point_0(cone_4, 1.0lf, b_1);
    if(is_nearer_0(other_0, _S27))
    {
        (*nearest_1) = other_0;
    }
    var w_0 : vec3<f64> = cross(cone_4.axis_0, normal_1);
    var falls_0 : f64 = dot(along_1, w_0);
    if(falls_0 != 0.0lf)
    {
        var t_2 : f64 = - dot(a_1, w_0) / falls_0;
        if(t_2 > 0.0lf)
        {
            _S26 = t_2 < 1.0lf;
        }
        else
        {
            _S26 = false;
        }
        if(_S26)
        {
            var other_1 : Nearest_0 = at_point_0(cone_4, t_2, a_1 + along_1 * vec3<f64>(t_2));
            if(is_nearer_0(other_1, (*nearest_1)))
            {
                (*nearest_1) = other_1;
            }
        }
    }
    var total_0 : f64 = (*nearest_1).sin_2 + abs((*nearest_1).cos_2);
    if(!(total_0 > 0.0lf))
    {
        return beyond_0();
    }
    var _S28 : f64;
    if(((*nearest_1).cos_2) >= 0.0lf)
    {
        _S28 = (*nearest_1).sin_2 / total_0;
    }
    else
    {
        _S28 = 1.0lf - (*nearest_1).cos_2 / total_0;
    }
    return _S28;
}

fn weight_0( sampled_5 : Sampled_0,  edge_0 : u32) -> f64
{
    var at_4 : u32 = u32(36) * launch_0.primitives_0 + u32(16) * edge_0;
    var _S29 : u32 = at_4 + u32(14);
    var _S30 : i32;
    if(is_silhouette_0(sampled_5.cone_0, at_4))
    {
        _S30 = i32(0);
    }
    else
    {
        _S30 = i32(1);
    }
    var factor_0 : f64 = primitives_1[_S29 + u32(_S30)];
    if(!(factor_0 > 0.0lf))
    {
        return 0.0lf;
    }
    var cone_5 : Cone_0 = sampled_5.cone_0;
    cone_5.all_edges_0 = true;
    var nearest_2 : Nearest_0;
    if(!((closest_on_edge_0(cone_5, at_4, &(nearest_2))) < (cone_5.limit_0)))
    {
        return 0.0lf;
    }
    var a_2 : vec3<f64> = primitive_vector_0(at_4) - cone_5.apex_0;
    var b_2 : vec3<f64> = primitive_vector_0(at_4 + u32(3)) - cone_5.apex_0;
    var along_2 : vec3<f64> = b_2 - a_2;
    return factor_0 * sqrt(dot(along_2, along_2)) / (dot(a_2, a_2) + dot(b_2, b_2));
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S31 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S32 : u32 = u32(2) + zero_0;
        _S31 = _S32;
        if(rounds_0 < _S32)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S31;
}

fn is_cut_short_0() -> bool
{
    return !loops_end_0(((launch_0.end_0) >> (u32(31))));
}

@compute
@workgroup_size(64, 1, 1)
fn sample_edges(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var query_1 : u32 = launch_0.first_0 + thread_0.x;
    if(query_1 >= (launch_0.end_0))
    {
        return;
    }
    var at_5 : u32 = u32(22) * query_1;
    var cone_6 : Cone_0;
    cone_6.apex_0 = query_vector_0(at_5);
    cone_6.axis_0 = query_vector_0(at_5 + u32(3));
    cone_6.plane_point_0 = query_vector_0(at_5 + u32(6));
    cone_6.plane_normal_0 = query_vector_0(at_5 + u32(9));
    cone_6.on_plane_0 = queries_0[at_5 + u32(12)];
    cone_6.size_0 = queries_0[at_5 + u32(13)];
    var _S33 : f64 = queries_0[at_5 + u32(14)];
    cone_6.limit_0 = _S33;
    cone_6.largest_0 = queries_0[at_5 + u32(15)];
    cone_6.all_edges_0 = (views_0[u32(3) * query_1].x) != u32(0);
    var sampled_6 : Sampled_0;
    sampled_6.cone_0 = cone_6;
    var _S34 : u32 = at_5 + u32(16);
    sampled_6.sin_0 = queries_0[_S34];
    sampled_6.cos_0 = queries_0[_S34 + u32(1)];
    sampled_6.clear_0 = queries_0[_S34 + u32(2)];
    sampled_6.size_1 = queries_0[_S34 + u32(3)];
    var leaf_1 : u32 = u32(0);
    var probability_1 : f64 = 0.0lf;
    var is_chosen_0 : bool;
    if(_S33 >= 0.0lf)
    {
        var _S35 : bool = descend_0(sampled_6, number_at_0(query_1, u32(0)), &(leaf_1), &(probability_1));
        is_chosen_0 = _S35;
    }
    else
    {
        is_chosen_0 = false;
    }
    var chosen_0 : u32;
    var answer_0 : u32;
    var chosen_weight_0 : f64;
    var sum_1 : f64;
    if(is_chosen_0)
    {
        var number_2 : Number_0 = number_at_0(query_1, u32(1));
        var _S36 : u32 = nodes_0[leaf_1].z;
        chosen_0 = u32(4294967295);
        chosen_weight_0 = 0.0lf;
        answer_0 = _S36;
        sum_1 = 0.0lf;
        for(;;)
        {
            if(answer_0 < (nodes_0[leaf_1].w))
            {
            }
            else
            {
                break;
            }
            var own_0 : f64 = weight_0(sampled_6, answer_0);
            if(!(own_0 > 0.0lf))
            {
                answer_0 = answer_0 + u32(1);
                continue;
            }
            var sum_2 : f64 = sum_1 + own_0;
            var share_0 : f64 = own_0 / sum_2;
            if((number_2.value_0) < share_0)
            {
                is_chosen_0 = true;
            }
            else
            {
                is_chosen_0 = chosen_0 == u32(4294967295);
            }
            if(is_chosen_0)
            {
                number_2.value_0 = number_2.value_0 / share_0;
            }
            else
            {
                number_2.value_0 = (number_2.value_0 - share_0) / (1.0lf - share_0);
            }
            if(!is_chosen_0)
            {
                sum_1 = sum_2;
                answer_0 = answer_0 + u32(1);
                continue;
            }
            chosen_0 = answer_0;
            chosen_weight_0 = own_0;
            sum_1 = sum_2;
            answer_0 = answer_0 + u32(1);
        }
    }
    else
    {
        chosen_0 = u32(4294967295);
        chosen_weight_0 = 0.0lf;
        sum_1 = 0.0lf;
    }
    var _S37 : bool = chosen_0 == u32(4294967295);
    if(_S37)
    {
        answer_0 = u32(4294967295);
    }
    else
    {
        answer_0 = leaf_starts_0[chosen_0];
    }
    if(is_cut_short_0())
    {
        chosen_0 = u32(4294967294);
    }
    else
    {
        chosen_0 = answer_0;
    }
    answers_0[query_1] = chosen_0;
    if(_S37)
    {
        chosen_weight_0 = 0.0lf;
    }
    else
    {
        chosen_weight_0 = probability_1 * (chosen_weight_0 / sum_1);
    }
    values_0[query_1] = chosen_weight_0;
    return;
}
