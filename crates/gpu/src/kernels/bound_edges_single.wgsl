// Compiled from bounds.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: be996b9947b4d3a2
// result: 94c56f7cfdc50394

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) capacity_0 : u32,
    @align(4) primitives_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(1) @group(0) var<storage, read> below_0 : array<u32>;

@binding(3) @group(0) var<storage, read> rough_0 : array<vec4<u32>>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(6) @group(0) var<storage, read_write> words_0 : array<u32>;

struct Four_0
{
     a_0 : vec3<f32>,
     b_0 : vec3<f32>,
     c_0 : vec3<f32>,
     d_0 : vec3<f32>,
};

fn four_0( v_0 : f32) -> Four_0
{
    var all_0 : Four_0;
    var _S1 : vec3<f32> = vec3<f32>(v_0, v_0, v_0);
    all_0.a_0 = _S1;
    all_0.b_0 = _S1;
    all_0.c_0 = _S1;
    all_0.d_0 = _S1;
    return all_0;
}

fn is_usable_normal_0( normal_0 : vec3<f32>,  along_0 : vec3<f32>) -> bool
{
    var _S2 : bool;
    if((dot(normal_0, normal_0)) > 0.5f)
    {
        _S2 = (abs(dot(normal_0, along_0))) <= 4.76837158203125e-07f;
    }
    else
    {
        _S2 = false;
    }
    return _S2;
}

struct LocalEdge_0
{
     start_0 : vec3<f32>,
     along_1 : vec3<f32>,
     first_1 : vec3<f32>,
     second_0 : vec3<f32>,
     is_usable_0 : bool,
};

fn edge_at_0( i_0 : u32) -> LocalEdge_0
{
    var edge_0 : LocalEdge_0;
    edge_0.start_0 = (bitcast<vec3<f32>>((rough_0[i_0].xyz)));
    var _S3 : vec3<f32> = (bitcast<vec3<f32>>((rough_0[launch_0.primitives_0 + i_0].xyz)));
    edge_0.along_1 = _S3;
    var _S4 : vec3<f32> = (bitcast<vec3<f32>>((rough_0[u32(2) * launch_0.primitives_0 + i_0].xyz)));
    edge_0.first_1 = _S4;
    edge_0.second_0 = (bitcast<vec3<f32>>((rough_0[u32(3) * launch_0.primitives_0 + i_0].xyz)));
    var _S5 : bool;
    if(is_usable_normal_0(_S4, _S3))
    {
        _S5 = is_usable_normal_0(edge_0.second_0, edge_0.along_1);
    }
    else
    {
        _S5 = false;
    }
    edge_0.is_usable_0 = _S5;
    return edge_0;
}

var<workgroup> shared_a_0 : array<vec3<f32>, i32(64)>;

var<workgroup> shared_b_0 : array<vec3<f32>, i32(64)>;

var<workgroup> shared_c_0 : array<vec3<f32>, i32(64)>;

var<workgroup> shared_d_0 : array<vec3<f32>, i32(64)>;

fn of_all_0( own_0 : Four_0,  thread_0 : u32,  is_sum_0 : bool) -> Four_0
{
    shared_a_0[thread_0] = own_0.a_0;
    shared_b_0[thread_0] = own_0.b_0;
    shared_c_0[thread_0] = own_0.c_0;
    shared_d_0[thread_0] = own_0.d_0;
    var half_size_0 : u32 = u32(32);
    for(;;)
    {
        if(half_size_0 > u32(0))
        {
        }
        else
        {
            break;
        }
        workgroupBarrier();
        if(thread_0 < half_size_0)
        {
            var other_0 : u32 = thread_0 + half_size_0;
            var a_1 : vec3<f32> = shared_a_0[thread_0];
            var b_1 : vec3<f32> = shared_b_0[thread_0];
            var c_1 : vec3<f32> = shared_c_0[thread_0];
            var d_1 : vec3<f32> = shared_d_0[thread_0];
            var _S6 : vec3<f32>;
            if(is_sum_0)
            {
                _S6 = a_1 + shared_a_0[other_0];
            }
            else
            {
                _S6 = max(a_1, shared_a_0[other_0]);
            }
            shared_a_0[thread_0] = _S6;
            var _S7 : vec3<f32>;
            if(is_sum_0)
            {
                _S7 = b_1 + shared_b_0[other_0];
            }
            else
            {
                _S7 = max(b_1, shared_b_0[other_0]);
            }
            shared_b_0[thread_0] = _S7;
            var _S8 : vec3<f32>;
            if(is_sum_0)
            {
                _S8 = c_1 + shared_c_0[other_0];
            }
            else
            {
                _S8 = max(c_1, shared_c_0[other_0]);
            }
            shared_c_0[thread_0] = _S8;
            var _S9 : vec3<f32>;
            if(is_sum_0)
            {
                _S9 = d_1 + shared_d_0[other_0];
            }
            else
            {
                _S9 = max(d_1, shared_d_0[other_0]);
            }
            shared_d_0[thread_0] = _S9;
        }
        half_size_0 = half_size_0 / u32(2);
    }
    workgroupBarrier();
    var all_1 : Four_0;
    all_1.a_0 = shared_a_0[i32(0)];
    all_1.b_0 = shared_b_0[i32(0)];
    all_1.c_0 = shared_c_0[i32(0)];
    all_1.d_0 = shared_d_0[i32(0)];
    workgroupBarrier();
    return all_1;
}

struct Spread_0
{
     x_0 : vec3<f32>,
     y_0 : vec3<f32>,
     z_0 : vec3<f32>,
};

fn spread_0( sum_0 : vec3<f32>,  squares_0 : vec3<f32>,  products_0 : vec3<f32>,  count_0 : f32) -> Spread_0
{
    var _S10 : vec3<f32> = vec3<f32>(count_0);
    var mean_0 : vec3<f32> = sum_0 / _S10;
    var own_1 : vec3<f32> = squares_0 / _S10 - mean_0 * mean_0;
    var _S11 : f32 = mean_0.y;
    var _S12 : f32 = mean_0.z;
    var _S13 : f32 = mean_0.x;
    var mixed_0 : vec3<f32> = products_0 / _S10 - vec3<f32>(_S11 * _S12, _S12 * _S13, _S13 * _S11);
    var m_0 : Spread_0;
    var _S14 : f32 = mixed_0.z;
    var _S15 : f32 = mixed_0.y;
    m_0.x_0 = vec3<f32>(own_1.x, _S14, _S15);
    var _S16 : f32 = mixed_0.x;
    m_0.y_0 = vec3<f32>(_S14, own_1.y, _S16);
    m_0.z_0 = vec3<f32>(_S15, _S16, own_1.z);
    return m_0;
}

fn normalized_or_0( v_1 : vec3<f32>,  other_1 : vec3<f32>) -> vec3<f32>
{
    var squared_0 : f32 = dot(v_1, v_1);
    var _S17 : vec3<f32>;
    if(squared_0 > 1.00000000317107685e-30f)
    {
        _S17 = v_1 / vec3<f32>(sqrt(squared_0));
    }
    else
    {
        _S17 = other_1;
    }
    return _S17;
}

fn times_0( m_1 : Spread_0,  v_2 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(m_1.x_0, v_2), dot(m_1.y_0, v_2), dot(m_1.z_0, v_2));
}

fn longest_0( m_2 : Spread_0) -> vec3<f32>
{
    var _S18 : Spread_0 = m_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < u32(5))
        {
        }
        else
        {
            break;
        }
        var trace_0 : f32 = _S18.x_0.x + _S18.y_0.y + _S18.z_0.z;
        if(!(trace_0 > 1.00000000317107685e-30f))
        {
            return vec3<f32>(1.0f, 0.0f, 0.0f);
        }
        var _S19 : vec3<f32> = vec3<f32>(trace_0);
        var _S20 : vec3<f32> = _S18.x_0 / _S19;
        _S18.x_0 = _S20;
        var _S21 : vec3<f32> = _S18.y_0 / _S19;
        _S18.y_0 = _S21;
        var _S22 : vec3<f32> = _S18.z_0 / _S19;
        _S18.z_0 = _S22;
        var square_0 : Spread_0;
        square_0.x_0 = times_0(_S18, _S20);
        square_0.y_0 = times_0(_S18, _S21);
        square_0.z_0 = times_0(_S18, _S22);
        _S18 = square_0;
        i_1 = i_1 + u32(1);
    }
    var column_0 : vec3<f32>;
    if((_S18.x_0.x) >= (_S18.y_0.y))
    {
        if((_S18.x_0.x) >= (_S18.z_0.z))
        {
            column_0 = _S18.x_0;
        }
        else
        {
            column_0 = _S18.z_0;
        }
    }
    else
    {
        if((_S18.y_0.y) >= (_S18.z_0.z))
        {
            column_0 = _S18.y_0;
        }
        else
        {
            column_0 = _S18.z_0;
        }
    }
    return normalized_or_0(column_0, vec3<f32>(1.0f, 0.0f, 0.0f));
}

fn longest_across_0( m_3 : Spread_0,  first_2 : vec3<f32>) -> vec3<f32>
{
    var size_0 : vec3<f32> = abs(first_2);
    var _S23 : f32 = size_0.x;
    var _S24 : f32 = size_0.y;
    var _S25 : bool;
    if(_S23 <= _S24)
    {
        _S25 = _S23 <= (size_0.z);
    }
    else
    {
        _S25 = false;
    }
    var away_0 : vec3<f32>;
    if(_S25)
    {
        away_0 = vec3<f32>(1.0f, 0.0f, 0.0f);
    }
    else
    {
        if(_S24 <= (size_0.z))
        {
            away_0 = vec3<f32>(0.0f, 1.0f, 0.0f);
        }
        else
        {
            away_0 = vec3<f32>(0.0f, 0.0f, 1.0f);
        }
    }
    var s_0 : vec3<f32> = normalized_or_0(cross(first_2, away_0), away_0);
    var t_0 : vec3<f32> = cross(first_2, s_0);
    var _S26 : vec3<f32> = times_0(m_3, t_0);
    var difference_0 : f32 = dot(s_0, times_0(m_3, s_0)) - dot(t_0, _S26);
    var mixed_1 : f32 = 2.0f * dot(s_0, _S26);
    var size_of_both_0 : f32 = sqrt(difference_0 * difference_0 + mixed_1 * mixed_1);
    if(!(size_of_both_0 > 1.00000000317107685e-30f))
    {
        return s_0;
    }
    var _S27 : f32 = 0.5f * clamp(difference_0 / size_of_both_0, -1.0f, 1.0f);
    var sin_0 : f32 = sqrt(0.5f - _S27);
    var _S28 : vec3<f32> = s_0 * vec3<f32>(sqrt(0.5f + _S27));
    var _S29 : f32;
    if(mixed_1 < 0.0f)
    {
        _S29 = - sin_0;
    }
    else
    {
        _S29 = sin_0;
    }
    return normalized_or_0(_S28 + t_0 * vec3<f32>(_S29), s_0);
}

fn half_area_0( size_1 : vec3<f32>) -> f32
{
    var _S30 : f32 = size_1.x;
    var _S31 : f32 = size_1.y;
    var _S32 : f32 = size_1.z;
    return _S30 * _S31 + _S31 * _S32 + _S32 * _S30;
}

@compute
@workgroup_size(64, 1, 1)
fn bound_edges(@builtin(workgroup_id) group_0 : vec3<u32>, @builtin(local_invocation_index) thread_1 : u32)
{
    var k_0 : u32;
    var p_0 : vec3<f32>;
    var view_margin_0 : f32;
    var _S33 : f32;
    var child_0 : u32 = launch_0.first_0 + group_0.x;
    var _S34 : u32 = u32(2) * child_0;
    var first_3 : u32 = below_0[_S34];
    var end_1 : u32 = below_0[_S34 + u32(1)];
    var origin_0 : vec3<f32> = (bitcast<vec3<f32>>((rough_0[min(first_3, launch_0.primitives_0 - u32(1))].xyz)));
    var _S35 : Four_0 = four_0(0.0f);
    var sums_0 : Four_0 = _S35;
    var _S36 : u32 = first_3 + thread_1;
    var i_2 : u32 = _S36;
    for(;;)
    {
        if(i_2 < end_1)
        {
        }
        else
        {
            break;
        }
        var edge_1 : LocalEdge_0 = edge_at_0(i_2);
        sums_0.a_0 = sums_0.a_0 + (edge_1.first_1 + edge_1.second_0);
        var _S37 : vec3<f32> = edge_1.start_0 - origin_0;
        k_0 = u32(0);
        p_0 = _S37;
        for(;;)
        {
            if(k_0 < u32(2))
            {
            }
            else
            {
                break;
            }
            sums_0.b_0 = sums_0.b_0 + p_0;
            sums_0.c_0 = sums_0.c_0 + p_0 * p_0;
            var _S38 : f32 = p_0.y;
            var _S39 : f32 = p_0.z;
            var _S40 : f32 = p_0.x;
            sums_0.d_0 = sums_0.d_0 + vec3<f32>(_S38 * _S39, _S39 * _S40, _S40 * _S38);
            var p_1 : vec3<f32> = p_0 + edge_1.along_1;
            k_0 = k_0 + u32(1);
            p_0 = p_1;
        }
        i_2 = i_2 + u32(64);
    }
    var _S41 : Four_0 = of_all_0(sums_0, thread_1, true);
    sums_0 = _S41;
    var ends_0 : Spread_0 = spread_0(sums_0.b_0, sums_0.c_0, sums_0.d_0, max(2.0f * f32(end_1 - first_3), 1.0f));
    const _S42 : vec3<f32> = vec3<f32>(1.0f, 0.0f, 0.0f);
    var mean_normal_0 : vec3<f32> = normalized_or_0(sums_0.a_0, _S42);
    var worst_0 : Four_0 = _S35;
    i_2 = _S36;
    for(;;)
    {
        if(i_2 < end_1)
        {
        }
        else
        {
            break;
        }
        var edge_2 : LocalEdge_0 = edge_at_0(i_2);
        var a_2 : vec3<f32> = cross(mean_normal_0, edge_2.first_1);
        var b_2 : vec3<f32> = cross(mean_normal_0, edge_2.second_0);
        var sin_1 : f32 = sqrt(max(dot(a_2, a_2), dot(b_2, b_2)));
        var _S43 : vec3<f32> = worst_0.a_0;
        if((min(dot(mean_normal_0, edge_2.first_1), dot(mean_normal_0, edge_2.second_0))) > 0.00999999977648258f)
        {
            view_margin_0 = 0.0f;
        }
        else
        {
            view_margin_0 = 1.0f;
        }
        if(edge_2.is_usable_0)
        {
            _S33 = 0.0f;
        }
        else
        {
            _S33 = 1.0f;
        }
        worst_0.a_0 = max(_S43, vec3<f32>(sin_1, view_margin_0, _S33));
        i_2 = i_2 + u32(64);
    }
    var _S44 : Four_0 = of_all_0(worst_0, thread_1, false);
    worst_0 = _S44;
    var sin_2 : f32 = worst_0.a_0.x + 0.0000152587890625f;
    var has_cone_0 : bool;
    if(sin_2 < 0.99800002574920654f)
    {
        has_cone_0 = (worst_0.a_0.y) == 0.0f;
    }
    else
    {
        has_cone_0 = false;
    }
    if(has_cone_0)
    {
        has_cone_0 = (worst_0.a_0.z) == 0.0f;
    }
    else
    {
        has_cone_0 = false;
    }
    var axis_0 : vec3<f32>;
    if(has_cone_0)
    {
        axis_0 = mean_normal_0;
    }
    else
    {
        axis_0 = longest_0(ends_0);
    }
    var across_0 : vec3<f32> = longest_across_0(ends_0, axis_0);
    var axis_1 : vec3<f32> = axis_0 * vec3<f32>(0.99999904632568359f);
    var _S45 : vec3<f32> = cross(axis_1, across_0);
    var boxes_0 : Four_0 = four_0(-3.00000000549775576e+38f);
    i_2 = _S36;
    for(;;)
    {
        if(i_2 < end_1)
        {
        }
        else
        {
            break;
        }
        var edge_3 : LocalEdge_0 = edge_at_0(i_2);
        var _S46 : vec3<f32> = edge_3.start_0 - origin_0;
        k_0 = u32(0);
        p_0 = _S46;
        for(;;)
        {
            if(k_0 < u32(2))
            {
            }
            else
            {
                break;
            }
            var own_2 : vec3<f32> = vec3<f32>(dot(axis_1, p_0), dot(across_0, p_0), dot(_S45, p_0));
            boxes_0.a_0 = max(boxes_0.a_0, own_2);
            boxes_0.b_0 = max(boxes_0.b_0, (vec3<f32>(0) - own_2));
            boxes_0.c_0 = max(boxes_0.c_0, p_0);
            boxes_0.d_0 = max(boxes_0.d_0, (vec3<f32>(0) - p_0));
            var p_2 : vec3<f32> = p_0 + edge_3.along_1;
            k_0 = k_0 + u32(1);
            p_0 = p_2;
        }
        i_2 = i_2 + u32(64);
    }
    var _S47 : Four_0 = of_all_0(boxes_0, thread_1, false);
    boxes_0 = _S47;
    var _S48 : vec3<f32> = vec3<f32>(0.5f);
    var _S49 : vec3<f32> = _S48 * (boxes_0.a_0 - boxes_0.b_0);
    var half_size_1 : vec3<f32> = _S48 * (boxes_0.a_0 + boxes_0.b_0);
    var upright_0 : vec3<f32> = _S48 * (boxes_0.c_0 + boxes_0.d_0);
    var _S50 : bool;
    if(!has_cone_0)
    {
        _S50 = !((half_area_0(half_size_1)) < (half_area_0(upright_0)));
    }
    else
    {
        _S50 = false;
    }
    var across_1 : vec3<f32>;
    var third_0 : vec3<f32>;
    var half_size_2 : vec3<f32>;
    if(_S50)
    {
        const _S51 : vec3<f32> = vec3<f32>(0.0f, 1.0f, 0.0f);
        const _S52 : vec3<f32> = vec3<f32>(0.0f, 0.0f, 1.0f);
        p_0 = _S48 * (boxes_0.c_0 - boxes_0.d_0);
        across_1 = _S51;
        third_0 = _S52;
        axis_0 = _S42;
        half_size_2 = upright_0;
    }
    else
    {
        p_0 = _S49;
        across_1 = across_0;
        third_0 = _S45;
        axis_0 = axis_1;
        half_size_2 = half_size_1;
    }
    var centre_0 : vec3<f32> = origin_0 + axis_0 * vec3<f32>(p_0.x) + across_1 * vec3<f32>(p_0.y) + third_0 * vec3<f32>(p_0.z);
    var farthest_0 : Four_0 = _S35;
    i_2 = _S36;
    for(;;)
    {
        if(i_2 < end_1)
        {
        }
        else
        {
            break;
        }
        var edge_4 : LocalEdge_0 = edge_at_0(i_2);
        var a_3 : vec3<f32> = edge_4.start_0 - centre_0;
        var b_3 : vec3<f32> = a_3 + edge_4.along_1;
        farthest_0.a_0 = max(farthest_0.a_0, vec3<f32>(max(abs(dot(edge_4.first_1, a_3)), abs(dot(edge_4.second_0, a_3))), max(dot(a_3, a_3), dot(b_3, b_3)), 0.0f));
        i_2 = i_2 + u32(64);
    }
    var _S53 : Four_0 = of_all_0(farthest_0, thread_1, false);
    farthest_0 = _S53;
    if(thread_1 != u32(0))
    {
        return;
    }
    var radius_0 : f32 = sqrt(farthest_0.a_0.y) * 1.0000152587890625f + 4.76837158203125e-07f;
    var error_0 : f32 = 0.0000152587890625f * radius_0 + 4.76837158203125e-07f;
    var cos_0 : f32 = sqrt(max(1.0f - sin_2 * sin_2, 9.99999997475242708e-07f));
    if(has_cone_0)
    {
        view_margin_0 = min((farthest_0.a_0.x + error_0) / cos_0, radius_0 * cos_0) * 1.0009765625f + error_0;
    }
    else
    {
        view_margin_0 = 0.0f;
    }
    var half_size_3 : vec3<f32> = half_size_2 + vec3<f32>(error_0, error_0, error_0);
    var slot_0 : u32 = child_0 % u32(8);
    var _S54 : u32 = u32(128) * (child_0 / u32(8)) + u32(4) * slot_0;
    var before_0 : u32 = u32(32) * (child_0 / u32(8)) + slot_0;
    var last_0 : vec4<u32> = nodes_0[before_0 + u32(24)];
    var rows_0 : array<vec4<u32>, i32(4)>;
    var _S55 : vec3<u32> = (bitcast<vec3<u32>>((centre_0)));
    if(has_cone_0)
    {
        _S33 = sin_2;
    }
    else
    {
        _S33 = 2.0f;
    }
    rows_0[i32(0)] = vec4<u32>(_S55, (bitcast<u32>((_S33))));
    rows_0[i32(1)] = vec4<u32>((bitcast<vec3<u32>>((axis_0))), (bitcast<u32>((half_size_3.x))));
    rows_0[i32(2)] = vec4<u32>((bitcast<vec3<u32>>((across_1))), (bitcast<u32>((half_size_3.y))));
    rows_0[i32(3)] = vec4<u32>((bitcast<u32>((view_margin_0))), (bitcast<u32>((half_size_3.z))), last_0.zw);
    var row_0 : u32 = u32(0);
    for(;;)
    {
        if(row_0 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S56 : vec4<u32>;
        if((last_0.z) == u32(4294967295))
        {
            _S56 = nodes_0[before_0 + u32(8) * row_0];
        }
        else
        {
            _S56 = rows_0[row_0];
        }
        k_0 = u32(0);
        for(;;)
        {
            if(k_0 < u32(4))
            {
            }
            else
            {
                break;
            }
            words_0[_S54 + u32(32) * row_0 + k_0] = _S56[k_0];
            k_0 = k_0 + u32(1);
        }
        row_0 = row_0 + u32(1);
    }
    return;
}
