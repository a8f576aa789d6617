// Compiled from render.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: eaa2832f82c845bd
// result: f5273d5251226b70

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

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(3) @group(0) var<storage, read> rough_0 : array<vec4<u32>>;

@binding(6) @group(0) var<storage, read_write> paths_0 : array<u32>;

fn word_0( at_0 : u32) -> u32
{
    return scene_0[at_0];
}

fn camera_word_0( at_1 : u32) -> u32
{
    return word_0(word_0(u32(13)) + at_1);
}

fn plus_0( a_0 : vec2<u32>,  b_0 : vec2<u32>) -> vec2<u32>
{
    var _S1 : u32 = a_0.x;
    var low_0 : u32 = _S1 + b_0.x;
    var _S2 : u32 = a_0.y + b_0.y;
    var _S3 : i32;
    if(low_0 < _S1)
    {
        _S3 = i32(1);
    }
    else
    {
        _S3 = i32(0);
    }
    return vec2<u32>(low_0, _S2 + u32(_S3));
}

fn shifted_xor_0( x_0 : vec2<u32>,  by_0 : u32) -> vec2<u32>
{
    var _S4 : u32 = x_0.y;
    return (x_0 ^ (vec2<u32>(((((x_0.x) >> (by_0))) | (((_S4 << ((u32(32) - by_0)))))), (_S4 >> (by_0)))));
}

fn product_0( a_1 : u32,  b_1 : u32) -> vec2<u32>
{
    var a0_0 : u32 = (a_1 & (u32(65535)));
    var a1_0 : u32 = (a_1 >> (u32(16)));
    var b0_0 : u32 = (b_1 & (u32(65535)));
    var b1_0 : u32 = (b_1 >> (u32(16)));
    var low_1 : u32 = a0_0 * b0_0;
    var middle_0 : u32 = a1_0 * b0_0 + ((low_1 >> (u32(16))));
    var rest_0 : u32 = ((middle_0 & (u32(65535)))) + a0_0 * b1_0;
    return vec2<u32>((((rest_0 << (u32(16)))) | (((low_1 & (u32(65535)))))), a1_0 * b1_0 + ((middle_0 >> (u32(16)))) + ((rest_0 >> (u32(16)))));
}

fn times_0( a_2 : vec2<u32>,  b_2 : vec2<u32>) -> vec2<u32>
{
    var _S5 : u32 = a_2.x;
    var _S6 : u32 = b_2.x;
    var low_2 : vec2<u32> = product_0(_S5, _S6);
    return vec2<u32>(low_2.x, low_2.y + _S5 * b_2.y + a_2.y * _S6);
}

fn mix_0( x_1 : vec2<u32>) -> vec2<u32>
{
    return shifted_xor_0(times_0(shifted_xor_0(times_0(shifted_xor_0(x_1, u32(30)), vec2<u32>(u32(484763065), u32(3210233709))), u32(27)), vec2<u32>(u32(321982955), u32(2496678331))), u32(31));
}

fn key_of_sample_0( seed_0 : vec2<u32>,  pixel_0 : u32,  sample_0 : u32) -> vec2<u32>
{
    return mix_0(((mix_0((seed_0 ^ ((mix_0(plus_0(vec2<u32>(pixel_0, u32(0)), vec2<u32>(u32(2135587861), u32(2654435769))))))))) ^ ((times_0(vec2<u32>(sample_0, u32(0)), vec2<u32>(u32(2135587861), u32(2654435769)))))));
}

fn random_bits_0( key_0 : vec2<u32>,  dimension_0 : u32) -> vec2<u32>
{
    return mix_0(plus_0(key_0, times_0(vec2<u32>(dimension_0 + u32(1), u32(0)), vec2<u32>(u32(2135587861), u32(2654435769)))));
}

fn precise_random_0( key_1 : vec2<u32>,  dimension_1 : u32) -> f64
{
    var bits_0 : vec2<u32> = random_bits_0(key_1, dimension_1);
    var _S7 : u32 = bits_0.y;
    return (f64((_S7 >> (u32(11)))) + f64((((_S7 << (u32(21)))) | ((((bits_0.x) >> (u32(11))))))) / 2048.0lf / 2048.0lf / 1024.0lf) / 2048.0lf / 1024.0lf;
}

fn camera_place_0( at_2 : u32) -> u32
{
    return word_0(u32(14)) + at_2;
}

fn camera_number_0( at_3 : u32) -> f64
{
    return primitives_0[camera_place_0(at_3)];
}

fn exponential_0( x_2 : f32) -> f32
{
    if(x_2 < -87.0f)
    {
        return 0.0f;
    }
    var power_0 : f32 = floor(x_2 * 1.4426950216293335f + 0.5f);
    var r_0 : f32 = x_2 - power_0 * 0.693359375f + power_0 * 0.00021219444170129f;
    return ((((((0.00019875691214111f * r_0 + 0.00139819993637502f) * r_0 + 0.00833345204591751f) * r_0 + 0.04166579619050026f) * r_0 + 0.1666666567325592f) * r_0 + 0.5f) * r_0 * r_0 + r_0 + 1.0f) * (bitcast<f32>(((u32(i32(power_0) + i32(127)) << (u32(23))))));
}

fn sine_cosine_0( angle_0 : f32) -> vec2<f32>
{
    var quarters_0 : f32 = floor(angle_0 * 0.63661974668502808f + 0.5f);
    var x_3 : f32 = angle_0 - quarters_0 * 1.5703125f - quarters_0 * 0.00048375129699707f - quarters_0 * 7.54979012640433211e-08f;
    var z_0 : f32 = x_3 * x_3;
    var sine_0 : f32 = ((-0.00019515295571182f * z_0 + 0.00833216123282909f) * z_0 - 0.16666655242443085f) * z_0 * x_3 + x_3;
    var cosine_0 : f32 = ((0.00002443315679557f * z_0 - 0.00138873164542019f) * z_0 + 0.04166664555668831f) * z_0 * z_0 - 0.5f * z_0 + 1.0f;
    var quarter_0 : i32 = (i32(quarters_0) & (i32(3)));
    var turned_0 : vec2<f32>;
    if(((quarter_0 & (i32(1)))) != i32(0))
    {
        turned_0 = vec2<f32>(cosine_0, - sine_0);
    }
    else
    {
        turned_0 = vec2<f32>(sine_0, cosine_0);
    }
    if(quarter_0 < i32(2))
    {
    }
    else
    {
        turned_0 = (vec2<f32>(0) - turned_0);
    }
    return turned_0;
}

fn sinc_0( x_4 : f32) -> f32
{
    if((abs(x_4)) < 0.00009999999747379f)
    {
        return 1.0f;
    }
    var nearest_0 : f32 = floor(x_4 + 0.5f);
    var sine_1 : f32 = sine_cosine_0(3.14159274101257324f * (x_4 - nearest_0)).x;
    var _S8 : f32;
    if(((i32(nearest_0) & (i32(1)))) != i32(0))
    {
        _S8 = - sine_1;
    }
    else
    {
        _S8 = sine_1;
    }
    return _S8 / (3.14159274101257324f * x_4);
}

fn filter_at_0( x_5 : f32) -> f32
{
    var kind_0 : u32 = camera_word_0(u32(2));
    var first_1 : f32 = (bitcast<f32>((camera_word_0(u32(3)))));
    var second_0 : f32 = (bitcast<f32>((camera_word_0(u32(4)))));
    var size_0 : f32 = abs(x_5);
    if(kind_0 == u32(1))
    {
        return 1.0f - size_0 * first_1;
    }
    if(kind_0 == u32(2))
    {
        return exponential_0(x_5 * x_5 * first_1) - 0.00033546262420714f;
    }
    if(kind_0 != u32(3))
    {
        return sinc_0(x_5) * sinc_0(x_5 * first_1);
    }
    var six_0 : vec4<f32>;
    if(size_0 < 1.0f)
    {
        var _S9 : f32 = 6.0f * second_0;
        six_0 = vec4<f32>(6.0f - 2.0f * first_1, 0.0f, 12.0f * first_1 + _S9 - 18.0f, 12.0f - 9.0f * first_1 - _S9);
    }
    else
    {
        six_0 = vec4<f32>(8.0f * first_1 + 24.0f * second_0, -12.0f * first_1 - 48.0f * second_0, 6.0f * first_1 + 30.0f * second_0, - first_1 - 6.0f * second_0);
    }
    return (((six_0.w * size_0 + six_0.z) * size_0 + six_0.y) * size_0 + six_0.x) / 6.0f;
}

fn along_side_0( side_0 : u32,  u_0 : f64,  weight_0 : ptr<function, f32>) -> f64
{
    var table_0 : u32 = camera_word_0(u32(6) + side_0);
    var start_0 : f64 = camera_number_0(table_0);
    var width_0 : f64 = camera_number_0(table_0 + u32(1));
    if((camera_word_0(u32(2))) == u32(0))
    {
        return start_0 + u_0 * (width_0 * 32.0lf);
    }
    var rest_1 : u32 = u32(16);
    var bin_0 : u32 = u32(0);
    for(;;)
    {
        if(rest_1 > u32(0))
        {
        }
        else
        {
            break;
        }
        if(u_0 >= (camera_number_0(table_0 + u32(3) + bin_0 + rest_1)))
        {
            bin_0 = bin_0 + rest_1;
        }
        rest_1 = rest_1 / u32(2);
    }
    var _S10 : u32 = table_0 + u32(3);
    var probability_0 : f64 = camera_number_0(_S10 + u32(32) + bin_0);
    var place_0 : f64 = start_0 + (f64(bin_0) + min((u_0 - camera_number_0(_S10 + bin_0)) / probability_0, 1.0lf)) * width_0;
    (*weight_0) = (*weight_0) * (filter_at_0(f32(place_0)) * f32(camera_number_0(table_0 + u32(2)) / probability_0));
    return place_0;
}

fn random_0( key_2 : vec2<u32>,  dimension_2 : u32) -> f32
{
    return f32(((random_bits_0(key_2, dimension_2).y) >> (u32(8)))) * 5.9604644775390625e-08f;
}

struct CameraSample_0
{
     key_3 : vec2<u32>,
     pixel_1 : u32,
     x_6 : f64,
     y_0 : f64,
     lens_0 : vec2<f32>,
     weight_1 : f32,
};

fn camera_sample_0( number_of_path_0 : u32) -> CameraSample_0
{
    var number_0 : u32 = input_0[i32(2)] + number_of_path_0;
    var pixels_0 : u32 = camera_word_0(u32(1));
    var columns_0 : u32 = camera_word_0(u32(0));
    var drawn_0 : CameraSample_0;
    var _S11 : u32 = number_0 % pixels_0;
    drawn_0.pixel_1 = _S11;
    var _S12 : vec2<u32> = vec2<u32>(input_0[i32(0)], input_0[i32(1)]);
    var _S13 : u32 = input_0[i32(3)];
    var _S14 : u32 = number_0 / pixels_0;
    drawn_0.key_3 = key_of_sample_0(_S12, _S11, _S13 + _S14);
    drawn_0.weight_1 = 1.0f;
    var column_0 : u32 = drawn_0.pixel_1 % columns_0;
    var row_0 : u32 = drawn_0.pixel_1 / columns_0;
    var _S15 : f64 = precise_random_0(drawn_0.key_3, u32(0));
    var _S16 : f32 = drawn_0.weight_1;
    var x_7 : f64 = along_side_0(column_0, _S15, &(_S16));
    var _S17 : u32 = columns_0 + row_0;
    var _S18 : f64 = precise_random_0(drawn_0.key_3, u32(1));
    var _S19 : f32 = _S16;
    var y_1 : f64 = along_side_0(_S17, _S18, &(_S19));
    drawn_0.weight_1 = _S19;
    drawn_0.x_6 = camera_number_0(u32(30)) - f64(column_0) - x_7;
    drawn_0.y_0 = camera_number_0(u32(31)) - f64(row_0) - y_1;
    drawn_0.lens_0 = vec2<f32>(0.0f);
    if((camera_word_0(u32(5))) != u32(0))
    {
        drawn_0.lens_0 = sine_cosine_0(6.28318548202514648f * random_0(drawn_0.key_3, u32(4))).yx * vec2<f32>(f32(sqrt(precise_random_0(drawn_0.key_3, u32(3)))));
    }
    return drawn_0;
}

fn primitive_vector_0( at_4 : u32) -> vec3<f64>
{
    return vec3<f64>(primitives_0[at_4], primitives_0[at_4 + u32(1)], primitives_0[at_4 + u32(2)]);
}

fn of_sample_0( vectors_0 : u32,  drawn_1 : CameraSample_0) -> vec3<f64>
{
    var at_5 : u32 = camera_place_0(vectors_0);
    return primitive_vector_0(at_5) + primitive_vector_0(at_5 + u32(3)) * vec3<f64>(drawn_1.x_6) + primitive_vector_0(at_5 + u32(6)) * vec3<f64>(drawn_1.y_0) + primitive_vector_0(at_5 + u32(9)) * vec3<f64>(f64(drawn_1.lens_0.x)) + primitive_vector_0(at_5 + u32(12)) * vec3<f64>(f64(drawn_1.lens_0.y));
}

fn component_0( v_0 : vec3<f64>,  axis_0 : u32) -> f64
{
    var _S20 : f64;
    if(axis_0 == u32(0))
    {
        _S20 = v_0.x;
    }
    else
    {
        if(axis_0 == u32(1))
        {
            _S20 = v_0.y;
        }
        else
        {
            _S20 = v_0.z;
        }
    }
    return _S20;
}

fn limit_at_0( which_0 : u32) -> f64
{
    return primitives_0[word_0(u32(15)) + which_0];
}

struct CameraRay_0
{
     start_1 : vec3<f64>,
     direction_0 : vec3<f64>,
     length_0 : f64,
     from_record_0 : f32,
     from_camera_0 : f32,
};

fn camera_ray_0( drawn_2 : CameraSample_0) -> CameraRay_0
{
    var to_depth_one_0 : vec3<f64> = of_sample_0(u32(0), drawn_2);
    var recorded_0 : vec3<f64> = of_sample_0(u32(15), drawn_2);
    var size_1 : f64 = sqrt(dot(to_depth_one_0, to_depth_one_0));
    var ray_0 : CameraRay_0;
    ray_0.direction_0 = to_depth_one_0 / vec3<f64>(size_1);
    var until_0 : f64 = camera_number_0(u32(33)) * size_1;
    var enter_0 : f64 = camera_number_0(u32(32)) * size_1;
    var exit_0 : f64 = until_0;
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
        var from_0 : f64 = component_0(recorded_0, axis_1);
        var speed_0 : f64 = component_0(ray_0.direction_0, axis_1);
        var ahead_0 : f64;
        if(speed_0 != 0.0lf)
        {
            if(speed_0 < 0.0lf)
            {
                ahead_0 = -1.0lf;
            }
            else
            {
                ahead_0 = 1.0lf;
            }
            var _S21 : f64 = min(exit_0, (ahead_0 - from_0) / speed_0);
            enter_0 = max(enter_0, (- ahead_0 - from_0) / speed_0);
            exit_0 = _S21;
        }
        else
        {
            if((abs(from_0)) > 1.0lf)
            {
                ahead_0 = - limit_at_0(u32(1));
            }
            else
            {
                ahead_0 = exit_0;
            }
            exit_0 = ahead_0;
        }
        axis_1 = axis_1 + u32(1);
    }
    var is_inside_0 : bool = enter_0 <= exit_0;
    if(!is_inside_0)
    {
        enter_0 = 0.0lf;
    }
    ray_0.start_1 = recorded_0 + ray_0.direction_0 * vec3<f64>(enter_0);
    if(is_inside_0)
    {
        exit_0 = until_0 - enter_0;
    }
    else
    {
        exit_0 = -1.0lf;
    }
    ray_0.length_0 = exit_0;
    ray_0.from_record_0 = f32(enter_0);
    ray_0.from_camera_0 = f32(camera_number_0(u32(34)) * size_1 + enter_0);
    return ray_0;
}

fn changing_0( value_0 : vec3<f32>,  change_0 : vec3<f32>) -> vec3<f32>
{
    return value_0;
}

fn still_0( value_1 : vec3<f32>) -> vec3<f32>
{
    return changing_0(value_1, vec3<f32>(0.0f));
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
     enter_1 : f64,
     edge_on_0 : f64,
     largest_0 : f64,
};

fn ray_along_0( origin_1 : vec3<f64>,  direction_1 : vec3<f64>,  t_min_1 : f64,  t_max_1 : f64,  axes_0 : ptr<function, u32>) -> Ray_0
{
    var size_2 : vec3<f32> = abs(vec3<f32>(direction_1));
    var _S22 : f32 = size_2.x;
    var _S23 : f32 = size_2.y;
    var _S24 : bool;
    if(_S22 >= _S23)
    {
        _S24 = _S22 >= (size_2.z);
    }
    else
    {
        _S24 = false;
    }
    var _S25 : i32;
    if(_S24)
    {
        _S25 = i32(0);
    }
    else
    {
        if(_S23 >= (size_2.z))
        {
            _S25 = i32(1);
        }
        else
        {
            _S25 = i32(2);
        }
    }
    var z_1 : u32 = u32(_S25);
    var x_8 : u32 = (z_1 + u32(1)) % u32(3);
    var y_2 : u32 = (z_1 + u32(2)) % u32(3);
    (*axes_0) = (((x_8 | (((y_2 << (u32(2))))))) | (((z_1 << (u32(4))))));
    var ray_1 : Ray_0;
    ray_1.origin_0 = origin_1;
    var along_0 : f64 = component_0(direction_1, z_1);
    ray_1.inverse_z_0 = 1.0lf / along_0;
    ray_1.shear_x_0 = component_0(direction_1, x_8) / along_0;
    ray_1.shear_y_0 = component_0(direction_1, y_2) / along_0;
    ray_1.t_min_0 = t_min_1;
    ray_1.t_max_0 = t_max_1;
    ray_1.local_per_t_0 = abs(along_0);
    ray_1.enter_1 = 0.0lf;
    ray_1.edge_on_0 = limit_at_0(u32(0));
    ray_1.largest_0 = limit_at_0(u32(1));
    return ray_1;
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
     axes_1 : u32,
};

fn ray_bound_0( view_0 : RayView_0,  limit_1 : f32,  node_1 : u32,  slot_1 : u32) -> f32
{
    var _S26 : u32 = u32(14) * node_1 + slot_1 / u32(4);
    var near_0 : f32 = 0.0f;
    var far_0 : f32 = limit_1;
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
        var _S27 : u32 = axis_2;
        var _S28 : u32 = _S26 + u32(2) * axis_2;
        var _S29 : u32 = slot_1 % u32(4);
        var low_3 : f32 = (bitcast<f32>((nodes_0[_S28][_S29])));
        var high_0 : f32 = (bitcast<f32>((nodes_0[_S28 + u32(6)][_S29])));
        var _S30 : bool = (view_0.inverse_0[axis_2]) < 0.0f;
        var _S31 : f32;
        if(_S30)
        {
            _S31 = high_0;
        }
        else
        {
            _S31 = low_3;
        }
        var _S32 : f32 = max(near_0, _S31 * view_0.inverse_0[_S27] - view_0.offset_near_0[axis_2]);
        var _S33 : f32;
        if(_S30)
        {
            _S33 = low_3;
        }
        else
        {
            _S33 = high_0;
        }
        var _S34 : f32 = min(far_0, _S33 * view_0.inverse_0[_S27] - view_0.offset_far_0[axis_2]);
        var _S35 : u32 = axis_2 + u32(1);
        near_0 = _S32;
        far_0 = _S34;
        axis_2 = _S35;
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
        var _S36 : u32 = k_0;
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
            var _S37 : u32 = j_0;
            var _S38 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S36]))
            {
                _S38 = true;
            }
            else
            {
                if((bounds_0[_S37]) == (bounds_0[_S36]))
                {
                    _S38 = j_0 < k_0;
                }
                else
                {
                    _S38 = false;
                }
            }
            if(_S38)
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
        var _S39 : f32;
        if((ray_child_0(node_2, slot_2)) == u32(4294967295))
        {
            _S39 = 3.00000000549775576e+38f;
        }
        else
        {
            _S39 = ray_bound_0(view_1, limit_3, node_2, slot_2);
        }
        bounds_1[slot_2] = _S39;
        slot_2 = slot_2 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn rounded_0( product_1 : f64,  largest_1 : f64) -> f64
{
    return min(product_1, largest_1);
}

fn corner_0( ray_2 : Ray_0,  axes_2 : u32,  at_6 : u32) -> vec3<f64>
{
    var relative_0 : vec3<f64> = primitive_vector_0(at_6) - ray_2.origin_0;
    var z_2 : f64 = component_0(relative_0, (axes_2 >> (u32(4))));
    return vec3<f64>(component_0(relative_0, (axes_2 & (u32(3)))) - rounded_0(ray_2.shear_x_0 * z_2, ray_2.largest_0), component_0(relative_0, (((axes_2 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_2.shear_y_0 * z_2, ray_2.largest_0), z_2);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_0 : f64,
     v_1 : f64,
     w_0 : f64,
};

fn intersect_0( ray_3 : Ray_0,  axes_3 : u32,  at_7 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_0 = 0.0lf;
    crossing_0.v_1 = 0.0lf;
    crossing_0.w_0 = 0.0lf;
    var a_3 : vec3<f64> = corner_0(ray_3, axes_3, at_7);
    var b_3 : vec3<f64> = corner_0(ray_3, axes_3, at_7 + u32(3));
    var c_0 : vec3<f64> = corner_0(ray_3, axes_3, at_7 + u32(6));
    var _S40 : f64 = c_0.x;
    var _S41 : f64 = b_3.y;
    var cx_by_0 : f64 = rounded_0(_S40 * _S41, ray_3.largest_0);
    var _S42 : f64 = c_0.y;
    var _S43 : f64 = b_3.x;
    var cy_bx_0 : f64 = rounded_0(_S42 * _S43, ray_3.largest_0);
    var _S44 : f64 = a_3.x;
    var ax_cy_0 : f64 = rounded_0(_S44 * _S42, ray_3.largest_0);
    var _S45 : f64 = a_3.y;
    var ay_cx_0 : f64 = rounded_0(_S45 * _S40, ray_3.largest_0);
    var bx_ay_0 : f64 = rounded_0(_S43 * _S45, ray_3.largest_0);
    var by_ax_0 : f64 = rounded_0(_S41 * _S44, ray_3.largest_0);
    var u_1 : f64 = cx_by_0 - cy_bx_0;
    var v_2 : f64 = ax_cy_0 - ay_cx_0;
    var w_1 : f64 = bx_ay_0 - by_ax_0;
    var _S46 : f64 = min(min(u_1, v_2), w_1);
    var _S47 : f64 = max(max(u_1, v_2), w_1);
    var _S48 : bool;
    if(_S46 < 0.0lf)
    {
        _S48 = _S47 > 0.0lf;
    }
    else
    {
        _S48 = false;
    }
    if(_S48)
    {
        return crossing_0;
    }
    var determinant_0 : f64 = u_1 + v_2 + w_1;
    if(_S46 <= 0.0lf)
    {
        _S48 = _S47 >= 0.0lf;
    }
    else
    {
        _S48 = false;
    }
    if(_S48)
    {
        if((abs(determinant_0)) <= (ray_3.edge_on_0 * (abs(cx_by_0) + abs(cy_bx_0) + abs(ax_cy_0) + abs(ay_cx_0) + abs(bx_ay_0) + abs(by_ax_0))))
        {
            return crossing_0;
        }
    }
    if(determinant_0 == 0.0lf)
    {
        return crossing_0;
    }
    var t_1 : f64 = (rounded_0(u_1 * a_3.z, ray_3.largest_0) + rounded_0(v_2 * b_3.z, ray_3.largest_0) + rounded_0(w_1 * c_0.z, ray_3.largest_0)) / determinant_0 * ray_3.inverse_z_0;
    if((ray_3.t_min_0) <= t_1)
    {
        _S48 = t_1 <= (ray_3.t_max_0);
    }
    else
    {
        _S48 = false;
    }
    crossing_0.is_hit_0 = _S48;
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

fn first_found_0( view_2 : RayView_0,  ray_4 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S49 : bool;
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
        var _S50 : u32 = way_0[level_0].y;
        if(_S50 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S51 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S51;
            continue;
        }
        var slot_3 : u32 = ((_S50 & (u32(15)))) - u32(1);
        way_0[level_0][i32(1)] = (_S50 >> (u32(4)));
        var _S52 : bool;
        if(!is_new_1)
        {
            _S52 = (ray_bound_0(view_2, limit_4, here_0.x, slot_3)) > limit_4;
        }
        else
        {
            _S52 = false;
        }
        if(_S52)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_0.x, slot_3);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S53 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S53;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S54 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S55 : u32 = leaf_starts_0[leaf_0];
        var limit_5 : f32 = limit_4;
        var i_0 : u32 = _S55;
        for(;;)
        {
            if(i_0 < _S54)
            {
            }
            else
            {
                break;
            }
            var crossing_1 : Crossing_0 = intersect_0((*ray_4), view_2.axes_1, u32(9) * i_0);
            if(!crossing_1.is_hit_0)
            {
                i_0 = i_0 + u32(1);
                continue;
            }
            if((found_0.face_1) == u32(4294967295))
            {
                _S49 = true;
            }
            else
            {
                _S49 = (crossing_1.t_0) < ((*ray_4).t_max_0);
            }
            var _S56 : bool;
            if(_S49)
            {
                _S56 = true;
            }
            else
            {
                _S56 = (face_0(i_0)) < (found_0.face_1);
            }
            var limit_6 : f32;
            if(_S56)
            {
                found_0.face_1 = face_0(i_0);
                found_0.triangle_1 = i_0;
                (*ray_4).t_max_0 = crossing_1.t_0;
                found_0.v_3 = crossing_1.v_1;
                found_0.w_2 = crossing_1.w_0;
                limit_6 = min(limit_5, f32(crossing_1.t_0 * (*ray_4).local_per_t_0 - (*ray_4).enter_1) + 2.0f * view_2.margin_0);
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
            _S49 = (found_0.face_1) != u32(4294967295);
        }
        else
        {
            _S49 = false;
        }
        if(_S49)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_0;
}

fn cast_0( origin_2 : vec3<f64>,  direction_2 : vec3<f64>,  t_min_2 : f64,  t_max_2 : f64,  any_1 : bool,  t_2 : ptr<function, f32>) -> Found_0
{
    var view_3 : RayView_0;
    var _S57 : u32 = view_3.axes_1;
    var _S58 : Ray_0 = ray_along_0(origin_2, direction_2, t_min_2, t_max_2, &(_S57));
    view_3.axes_1 = _S57;
    var ray_5 : Ray_0 = _S58;
    var _S59 : vec3<f32> = vec3<f32>(direction_2 / vec3<f64>(ray_5.local_per_t_0));
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
        var _S60 : f32 = max(abs(_S59[axis_3]), 8.67361737988403547e-19f);
        var _S61 : f32;
        if((_S59[axis_3]) < 0.0f)
        {
            _S61 = -1.0f / _S60;
        }
        else
        {
            _S61 = 1.0f / _S60;
        }
        view_3.inverse_0[axis_3] = _S61;
        axis_3 = axis_3 + u32(1);
    }
    var offset_0 : vec3<f32> = vec3<f32>(origin_2) * view_3.inverse_0;
    var wider_0 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_3.inverse_0);
    view_3.offset_near_0 = offset_0 + wider_0;
    view_3.offset_far_0 = offset_0 - wider_0;
    view_3.limit_0 = min(f32(t_max_2 * ray_5.local_per_t_0), 8.0f) + 3.814697265625e-06f;
    view_3.margin_0 = 3.814697265625e-06f;
    var found_1 : Found_0 = first_found_0(view_3, &(ray_5), any_1);
    (*t_2) = f32(ray_5.t_max_0);
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
    var place_1 : Place_0;
    place_1.triangle_2 = triangle_3;
    var _S62 : f32 = f32(v_5);
    place_1.v_4 = _S62;
    var _S63 : f32 = f32(w_4);
    place_1.w_3 = _S63;
    place_1.v_rest_0 = f32(v_5 - f64(_S62));
    place_1.w_rest_0 = f32(w_4 - f64(_S63));
    return place_1;
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
    return word_0(u32(10)) + u32(7) * word_0(triangle_record_0(triangle_5));
}

fn cross_of_0( triangle_6 : u32) -> vec3<f32>
{
    var at_8 : u32 = u32(9) * triangle_6;
    var a_4 : vec3<f64> = primitive_vector_0(at_8);
    return cross(vec3<f32>(primitive_vector_0(at_8 + u32(3)) - a_4), vec3<f32>(primitive_vector_0(at_8 + u32(6)) - a_4));
}

fn emitter_seen_0( found_3 : Found_0,  direction_3 : vec3<f32>) -> u32
{
    if((found_3.face_1) == u32(4294967295))
    {
        return word_0(u32(8));
    }
    var emitter_0 : u32 = word_0(shape_of_0(found_3.triangle_1) + u32(4));
    var _S64 : bool;
    if(emitter_0 != u32(4294967295))
    {
        _S64 = (dot(cross_of_0(found_3.triangle_1), direction_3)) < 0.0f;
    }
    else
    {
        _S64 = false;
    }
    var _S65 : u32;
    if(_S64)
    {
        _S65 = emitter_0;
    }
    else
    {
        _S65 = u32(4294967295);
    }
    return _S65;
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
     a_5 : vec2<f64>,
     b_4 : vec2<f64>,
     c_1 : vec2<f64>,
};

fn Corners2_x24init_0( a_6 : vec2<f64>,  b_5 : vec2<f64>,  c_2 : vec2<f64>) -> Corners2_0
{
    var _S66 : Corners2_0;
    _S66.a_5 = a_6;
    _S66.b_4 = b_5;
    _S66.c_1 = c_2;
    return _S66;
}

fn number_1( at_9 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_9])));
}

fn precise_0( at_10 : u32) -> f64
{
    return f64(number_1(at_10)) + f64(number_1(at_10 + u32(1)));
}

fn uvs_of_0( triangle_7 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f64>(0.0lf, 0.0lf), vec2<f64>(1.0lf, 0.0lf), vec2<f64>(0.0lf, 1.0lf));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_7) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_11 : u32 = uvs_at_0 + u32(12) * word_0(triangle_record_0(triangle_7) + u32(1));
    uvs_0.a_5 = vec2<f64>(precise_0(at_11), precise_0(at_11 + u32(2)));
    uvs_0.b_4 = vec2<f64>(precise_0(at_11 + u32(4)), precise_0(at_11 + u32(6)));
    uvs_0.c_1 = vec2<f64>(precise_0(at_11 + u32(8)), precise_0(at_11 + u32(10)));
    return uvs_0;
}

fn row_at_0( at_12 : u32) -> vec3<f64>
{
    return vec3<f64>(precise_0(at_12), precise_0(at_12 + u32(2)), precise_0(at_12 + u32(4)));
}

fn floor_of_0( x_9 : f64) -> i32
{
    return i32(clamp(f32(floor(x_9)), -1.0e+09f, 1.0e+09f));
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
     value_2 : vec2<f64>,
};

fn between_0( texels_1 : vec4<u32>,  place_2 : Point_0) -> Lookup_0
{
    var _S67 : vec2<f32> = vec2<f32>(place_2.value_2 - floor(place_2.value_2));
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - _S67;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S68 : f32 = back_0.x;
    var _S69 : f32 = back_0.y;
    var _S70 : f32 = _S67.x;
    var _S71 : f32 = _S67.y;
    lookup_1.weights_0 = vec4<f32>(_S68 * _S69, _S70 * _S69, _S68 * _S71, _S70 * _S71);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_1 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var place_3 : vec2<f64> = uv_0.value_2 * vec2<f64>(vec2<f32>(f32(width_1), f32(height_0)));
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_1 : u32 = wrapped_0(floor_of_0(place_3.y), height_0, wrap_1);
        var _S72 : u32 = row_1 * u32(width_1);
        var _S73 : u32 = wrapped_0(floor_of_0(place_3.x), width_1, wrap_1);
        return one_texel_0(_S72 + _S73);
    }
    var centred_0 : Point_0;
    var _S74 : vec2<f64> = place_3 - vec2<f64>(0.5lf);
    centred_0.value_2 = _S74;
    var x_10 : i32 = floor_of_0(_S74.x);
    var y_3 : i32 = floor_of_0(_S74.y);
    var _S75 : u32 = wrapped_0(y_3, height_0, wrap_1);
    var _S76 : u32 = u32(width_1);
    var first_2 : u32 = _S75 * _S76;
    var _S77 : u32 = wrapped_0(y_3 + i32(1), height_0, wrap_1);
    var second_1 : u32 = _S77 * _S76;
    var left_0 : u32 = wrapped_0(x_10, width_1, wrap_1);
    var right_0 : u32 = wrapped_0(x_10 + i32(1), width_1, wrap_1);
    return between_0(vec4<u32>(first_2 + left_0, first_2 + right_0, second_1 + left_0, second_1 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_4 : Place_0) -> Lookup_0
{
    var kind_1 : u32 = word_0(texture_1);
    if(kind_1 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_1 : u32 = triangle_record_0(place_4.triangle_2) + u32(1);
    if(kind_1 == u32(4))
    {
        return one_texel_0(word_0(record_1));
    }
    if(kind_1 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_1 + u32(1)), word_0(record_1 + u32(2)), word_0(record_1 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_4.v_4 - place_4.w_3, place_4.v_4, place_4.w_3, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_4.triangle_2);
    var _S78 : u32 = texture_1 + u32(6);
    var uv_1 : Point_0;
    var _S79 : vec3<f64> = vec3<f64>(uvs_1.a_5 + (uvs_1.b_4 - uvs_1.a_5) * vec2<f64>((f64(place_4.v_4) + f64(place_4.v_rest_0))) + (uvs_1.c_1 - uvs_1.a_5) * vec2<f64>((f64(place_4.w_3) + f64(place_4.w_rest_0))), 1.0lf);
    uv_1.value_2 = vec2<f64>(dot(_S79, row_at_0(_S78)), dot(_S79, row_at_0(_S78 + u32(6))));
    if(kind_1 == u32(1))
    {
        var _S80 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S80;
    }
    var half_of_period_0 : vec2<f64> = uv_1.value_2 - floor(uv_1.value_2);
    var _S81 : i32;
    if(((half_of_period_0.x) > 0.5lf) != ((half_of_period_0.y) > 0.5lf))
    {
        _S81 = i32(1);
    }
    else
    {
        _S81 = i32(0);
    }
    return one_texel_0(u32(_S81));
}

fn vector_at_0( at_13 : u32) -> vec3<f32>
{
    return vec3<f32>(number_1(at_13), number_1(at_13 + u32(1)), number_1(at_13 + u32(2)));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_1 : vec4<f32>) -> vec3<f32>
{
    var _S82 : u32 = word_0(texture_2 + u32(1));
    var _S83 : u32 = texture_2 + u32(19);
    var _S84 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_3 : vec3<f32> = _S84;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_14 : u32 = _S83 + _S82 * lookup_3.texels_0[k_1];
        var _S85 : vec3<f32>;
        if(_S82 == u32(1))
        {
            _S85 = vec3<f32>(number_1(at_14));
        }
        else
        {
            _S85 = vector_at_0(at_14);
        }
        var value_4 : vec3<f32> = value_3 + _S85 * vec3<f32>(weights_1[k_1]);
        k_1 = k_1 + u32(1);
        value_3 = value_4;
    }
    return value_3;
}

fn looked_up_0( texture_3 : u32,  lookup_4 : Lookup_0,  place_change_0 : vec2<f32>) -> vec3<f32>
{
    return weighted_texels_0(texture_3, lookup_4, lookup_4.weights_0);
}

fn shown_0( texture_4 : u32,  place_5 : Place_0) -> vec3<f32>
{
    var _S86 : Lookup_0 = lookup_at_0(texture_4, place_5);
    return looked_up_0(texture_4, _S86, vec2<f32>(0.0f));
}

fn value_of_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vector_0;
}

fn angle_of_0( x_11 : f32,  y_4 : f32) -> f32
{
    var _S87 : f32 = abs(x_11);
    var _S88 : f32 = abs(y_4);
    var _S89 : f32 = min(_S87, _S88);
    var _S90 : f32 = max(_S87, _S88);
    var is_steep_0 : bool = _S89 > (0.41421356797218323f * _S90);
    var above_0 : f32;
    if(is_steep_0)
    {
        above_0 = _S89 - _S90;
    }
    else
    {
        above_0 = _S89;
    }
    var below_0 : f32;
    if(is_steep_0)
    {
        below_0 = _S89 + _S90;
    }
    else
    {
        below_0 = _S90;
    }
    if(below_0 > 0.0f)
    {
    }
    else
    {
        below_0 = 1.0f;
    }
    var t_3 : f32 = above_0 / below_0;
    var z_3 : f32 = t_3 * t_3;
    var angle_1 : f32 = (((0.08053744584321976f * z_3 - 0.13877685368061066f) * z_3 + 0.19977711141109467f) * z_3 - 0.33332949876785278f) * z_3 * t_3 + t_3;
    var angle_2 : f32;
    if(is_steep_0)
    {
        angle_2 = angle_1 + 0.78539818525314331f;
    }
    else
    {
        angle_2 = angle_1;
    }
    if(_S88 > _S87)
    {
        angle_2 = 1.57079637050628662f - angle_2;
    }
    if(x_11 < 0.0f)
    {
        angle_2 = 3.14159274101257324f - angle_2;
    }
    if(y_4 < 0.0f)
    {
        above_0 = - angle_2;
    }
    else
    {
        above_0 = angle_2;
    }
    return above_0;
}

fn map_place_0( map_0 : u32,  direction_4 : vec3<f32>) -> vec2<f32>
{
    var _S91 : u32 = map_0 + u32(2);
    var d_0 : vec3<f32> = vector_at_0(_S91) * vec3<f32>(direction_4.x) + vector_at_0(_S91 + u32(3)) * vec3<f32>(direction_4.y) + vector_at_0(_S91 + u32(6)) * vec3<f32>(direction_4.z);
    return vec2<f32>(angle_of_0(- d_0.z, d_0.x) * 0.15915493667125702f * f32(word_0(map_0)) - 0.5f, angle_of_0(d_0.y, length(d_0.xz)) * 0.31830987334251404f * (f32(word_0(map_0 + u32(1))) - 1.0f));
}

fn in_map_0( map_1 : u32,  direction_5 : vec3<f32>) -> Lookup_0
{
    var _S92 : vec2<f64> = vec2<f64>(map_place_0(map_1, direction_5));
    var point_0 : Point_0;
    point_0.value_2 = _S92;
    var x_12 : i32 = floor_of_0(_S92.x);
    var y_5 : i32 = floor_of_0(_S92.y);
    var width_2 : i32 = i32(word_0(map_1));
    var height_1 : i32 = i32(word_0(map_1 + u32(1)));
    var left_1 : u32 = wrapped_0(x_12, width_2, u32(0));
    var right_1 : u32 = wrapped_0(x_12 + i32(1), width_2, u32(0));
    var _S93 : u32 = wrapped_0(y_5, height_1, u32(2));
    var _S94 : u32 = u32(width_2);
    var first_3 : u32 = _S93 * _S94;
    var _S95 : u32 = wrapped_0(y_5 + i32(1), height_1, u32(2));
    var second_2 : u32 = _S95 * _S94;
    return between_0(vec4<u32>(first_3 + left_1, first_3 + right_1, second_2 + left_1, second_2 + right_1), point_0);
}

fn emitted_0( emitter_2 : u32,  place_6 : Place_0,  direction_6 : vec3<f32>) -> vec3<f32>
{
    var record_2 : u32 = emitter_record_0(emitter_2);
    var texture_5 : u32 = word_0(record_2 + u32(1));
    if(!is_map_0(record_2))
    {
        var _S96 : vec3<f32> = shown_0(texture_5, place_6);
        return _S96;
    }
    var change_1 : vec2<f32> = vec2<f32>(0.0f);
    var factor_0 : vec3<f32> = looked_up_0(word_0(texture_5 + u32(12)), one_texel_0(u32(0)), change_1);
    var _S97 : u32 = word_0(texture_5 + u32(11));
    var _S98 : Lookup_0 = in_map_0(texture_5, value_of_0(direction_6));
    return looked_up_0(_S97, _S98, change_1) * factor_0;
}

fn reaches_0( segments_0 : u32) -> bool
{
    return segments_0 <= (word_0(u32(0)));
}

struct Path_0
{
     throughput_0 : vec3<f32>,
     direction_7 : vec3<f32>,
     place_7 : Place_0,
     key_4 : vec2<u32>,
     direction_rest_0 : vec3<f32>,
     light_0 : vec3<f32>,
};

fn begin_0( number_of_path_1 : u32,  path_0 : ptr<function, Path_0>) -> bool
{
    var drawn_3 : CameraSample_0 = camera_sample_0(number_of_path_1);
    var ray_6 : CameraRay_0 = camera_ray_0(drawn_3);
    var _S99 : vec3<f32> = vec3<f32>(ray_6.direction_0);
    (*path_0).key_4 = drawn_3.key_3;
    (*path_0).throughput_0 = still_0(vec3<f32>(1.0f));
    atomicStore(&(sums_0[u32(4) + number_of_path_1]), (bitcast<u32>((drawn_3.weight_1))));
    var t_4 : f32 = 0.0f;
    var found_4 : Found_0;
    found_4.face_1 = u32(4294967295);
    found_4.triangle_1 = u32(0);
    found_4.v_3 = 0.0lf;
    found_4.w_2 = 0.0lf;
    var _S100 : bool;
    if((ray_6.length_0) >= 0.0lf)
    {
        _S100 = (word_0(u32(14))) != u32(0);
    }
    else
    {
        _S100 = false;
    }
    if(_S100)
    {
        found_4 = cast_0(ray_6.start_1, ray_6.direction_0, 0.0lf, ray_6.length_0, false, &(t_4));
    }
    var _S101 : Place_0 = place_of_0(found_4);
    (*path_0).place_7 = _S101;
    (*path_0).direction_7 = _S99;
    (*path_0).direction_rest_0 = vec3<f32>(ray_6.direction_0 - vec3<f64>(_S99));
    var _S102 : vec3<f32> = still_0(vec3<f32>(0.0f));
    var emitter_3 : u32 = emitter_seen_0(found_4, _S99);
    if(emitter_3 != u32(4294967295))
    {
        _S100 = (word_0(u32(4))) != u32(0);
    }
    else
    {
        _S100 = false;
    }
    var light_1 : vec3<f32>;
    if(_S100)
    {
        var _S103 : vec3<f32> = emitted_0(emitter_3, _S101, (*path_0).direction_7);
        light_1 = _S103;
    }
    else
    {
        light_1 = _S102;
    }
    (*path_0).light_0 = light_1;
    if((found_4.face_1) != u32(4294967295))
    {
        _S100 = reaches_0(u32(2));
    }
    else
    {
        _S100 = false;
    }
    return _S100;
}

fn set_word_0( path_1 : u32,  which_1 : u32,  value_5 : u32)
{
    paths_0[which_1 * launch_0.room_0 + path_1] = value_5;
    return;
}

fn set_vector_0( path_2 : u32,  which_2 : ptr<function, u32>,  value_6 : vec3<f32>)
{
    var axis_4 : u32 = u32(0);
    for(;;)
    {
        if(axis_4 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_2, (*which_2) + axis_4, (bitcast<u32>((value_6[axis_4]))));
        axis_4 = axis_4 + u32(1);
    }
    (*which_2) = (*which_2) + u32(3);
    return;
}

fn set_vector_1( path_3 : u32,  which_3 : ptr<function, u32>,  value_7 : vec3<f32>)
{
    var axis_5 : u32 = u32(0);
    for(;;)
    {
        if(axis_5 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_3, (*which_3) + axis_5, (bitcast<u32>((value_7[axis_5]))));
        axis_5 = axis_5 + u32(1);
    }
    (*which_3) = (*which_3) + u32(3);
    return;
}

fn set_changing_0( path_4 : u32,  which_4 : ptr<function, u32>,  vector_1 : vec3<f32>)
{
    set_vector_1(path_4, &((*which_4)), value_of_0(vector_1));
    return;
}

fn set_place_0( path_5 : u32,  which_5 : ptr<function, u32>,  place_8 : Place_0)
{
    set_word_0(path_5, (*which_5), place_8.triangle_2);
    set_word_0(path_5, (*which_5) + u32(1), (bitcast<u32>((place_8.v_4))));
    set_word_0(path_5, (*which_5) + u32(2), (bitcast<u32>((place_8.w_3))));
    set_word_0(path_5, (*which_5) + u32(3), (bitcast<u32>((place_8.v_rest_0))));
    set_word_0(path_5, (*which_5) + u32(4), (bitcast<u32>((place_8.w_rest_0))));
    (*which_5) = (*which_5) + u32(5);
    return;
}

fn store_0( number_of_path_2 : u32,  path_6 : Path_0)
{
    var at_15 : u32 = u32(1);
    set_changing_0(number_of_path_2, &(at_15), path_6.light_0);
    set_changing_0(number_of_path_2, &(at_15), path_6.throughput_0);
    set_changing_0(number_of_path_2, &(at_15), path_6.direction_7);
    set_place_0(number_of_path_2, &(at_15), path_6.place_7);
    var _S104 : u32 = at_15 + u32(1);
    set_word_0(number_of_path_2, at_15, path_6.key_4.x);
    at_15 = _S104 + u32(1);
    set_word_0(number_of_path_2, _S104, path_6.key_4.y);
    set_vector_0(number_of_path_2, &(at_15), path_6.direction_rest_0);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S105 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S106 : u32 = u32(2) + zero_0;
        _S105 = _S106;
        if(rounds_0 < _S106)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S105;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S107 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn begin_paths(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var number_of_path_3 : u32 = launch_0.first_0 + thread_0.x;
    if(number_of_path_3 >= (launch_0.end_0))
    {
        return;
    }
    var path_7 : Path_0;
    var goes_on_0 : bool = begin_0(number_of_path_3, &(path_7));
    store_0(number_of_path_3, path_7);
    var _S108 : u32;
    if(goes_on_0)
    {
        _S108 = number_of_path_3;
    }
    else
    {
        _S108 = u32(4294967295);
    }
    set_word_0(number_of_path_3, u32(0), _S108);
    check_loops_0();
    return;
}
