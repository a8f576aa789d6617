// Compiled from forward.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: abe3870cd5efa04f
// result: 263b2dfa793d7a52

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

@binding(2) @group(0) var<storage, read> primitives_0 : array<f32>;

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(3) @group(0) var<storage, read> rough_0 : array<vec4<u32>>;

@binding(6) @group(0) var<storage, read_write> paths_0 : array<u32>;

struct DiffPair_float_0
{
     primal_0 : f32,
     differential_0 : f32,
};

struct DiffPair_vectorx3Cfloatx2C2x3E_0
{
     primal_0 : vec2<f32>,
     differential_0 : vec2<f32>,
};

fn _d_sqrt_0( dpx_0 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S1 : DiffPair_float_0 = DiffPair_float_0( sqrt(dpx_0.primal_0), 0.5f / sqrt(max(1.00000001168609742e-07f, dpx_0.primal_0)) * dpx_0.differential_0 );
    return _S1;
}

fn s_fwd_length_impl_0( dpx_1 : DiffPair_vectorx3Cfloatx2C2x3E_0) -> DiffPair_float_0
{
    var _S2 : f32 = dpx_1.primal_0[i32(0)];
    var _S3 : f32 = dpx_1.differential_0[i32(0)] * dpx_1.primal_0[i32(0)];
    var _S4 : f32 = dpx_1.primal_0[i32(1)];
    var _S5 : f32 = dpx_1.differential_0[i32(1)] * dpx_1.primal_0[i32(1)];
    var _S6 : DiffPair_float_0 = DiffPair_float_0( _S2 * _S2 + _S4 * _S4, _S3 + _S3 + (_S5 + _S5) );
    var _S7 : DiffPair_float_0 = _d_sqrt_0(_S6);
    var _S8 : DiffPair_float_0 = DiffPair_float_0( _S7.primal_0, _S7.differential_0 );
    return _S8;
}

fn _d_max_0( dpx_2 : DiffPair_float_0,  dpy_0 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S9 : f32 = max(dpx_2.primal_0, dpy_0.primal_0);
    var _S10 : f32;
    if((dpx_2.primal_0) > (dpy_0.primal_0))
    {
        _S10 = dpx_2.differential_0;
    }
    else
    {
        if((dpx_2.primal_0) < (dpy_0.primal_0))
        {
            _S10 = dpy_0.differential_0;
        }
        else
        {
            _S10 = 0.5f * (dpx_2.differential_0 + dpy_0.differential_0);
        }
    }
    var _S11 : DiffPair_float_0 = DiffPair_float_0( _S9, _S10 );
    return _S11;
}

fn _d_abs_0( dpx_3 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S12 : DiffPair_float_0 = DiffPair_float_0( abs(dpx_3.primal_0), select(select(-1.0f, 0.0f, (dpx_3.primal_0) == 0.0f), 1.0f, (dpx_3.primal_0) > 0.0f) * dpx_3.differential_0 );
    return _S12;
}

fn _d_min_0( dpx_4 : DiffPair_float_0,  dpy_1 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S13 : f32 = min(dpx_4.primal_0, dpy_1.primal_0);
    var _S14 : f32;
    if((dpx_4.primal_0) < (dpy_1.primal_0))
    {
        _S14 = dpx_4.differential_0;
    }
    else
    {
        if((dpx_4.primal_0) > (dpy_1.primal_0))
        {
            _S14 = dpy_1.differential_0;
        }
        else
        {
            _S14 = 0.5f * (dpx_4.differential_0 + dpy_1.differential_0);
        }
    }
    var _S15 : DiffPair_float_0 = DiffPair_float_0( _S13, _S14 );
    return _S15;
}

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
    var _S16 : u32 = a_0.x;
    var low_0 : u32 = _S16 + b_0.x;
    var _S17 : u32 = a_0.y + b_0.y;
    var _S18 : i32;
    if(low_0 < _S16)
    {
        _S18 = i32(1);
    }
    else
    {
        _S18 = i32(0);
    }
    return vec2<u32>(low_0, _S17 + u32(_S18));
}

fn shifted_xor_0( x_0 : vec2<u32>,  by_0 : u32) -> vec2<u32>
{
    var _S19 : u32 = x_0.y;
    return (x_0 ^ (vec2<u32>(((((x_0.x) >> (by_0))) | (((_S19 << ((u32(32) - by_0)))))), (_S19 >> (by_0)))));
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
    var _S20 : u32 = a_2.x;
    var _S21 : u32 = b_2.x;
    var low_2 : vec2<u32> = product_0(_S20, _S21);
    return vec2<u32>(low_2.x, low_2.y + _S20 * b_2.y + a_2.y * _S21);
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

fn precise_random_0( key_1 : vec2<u32>,  dimension_1 : u32) -> f32
{
    return f32(((random_bits_0(key_1, dimension_1).y) >> (u32(8)))) / 4096.0f / 4096.0f;
}

fn camera_place_0( at_2 : u32) -> u32
{
    return word_0(u32(14)) + at_2;
}

fn camera_number_0( at_3 : u32) -> f32
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
    var _S22 : f32;
    if(((i32(nearest_0) & (i32(1)))) != i32(0))
    {
        _S22 = - sine_1;
    }
    else
    {
        _S22 = sine_1;
    }
    return _S22 / (3.14159274101257324f * x_4);
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
        var _S23 : f32 = 6.0f * second_0;
        six_0 = vec4<f32>(6.0f - 2.0f * first_1, 0.0f, 12.0f * first_1 + _S23 - 18.0f, 12.0f - 9.0f * first_1 - _S23);
    }
    else
    {
        six_0 = vec4<f32>(8.0f * first_1 + 24.0f * second_0, -12.0f * first_1 - 48.0f * second_0, 6.0f * first_1 + 30.0f * second_0, - first_1 - 6.0f * second_0);
    }
    return (((six_0.w * size_0 + six_0.z) * size_0 + six_0.y) * size_0 + six_0.x) / 6.0f;
}

fn along_side_0( side_0 : u32,  u_0 : f32,  weight_0 : ptr<function, f32>) -> f32
{
    var table_0 : u32 = camera_word_0(u32(6) + side_0);
    var start_0 : f32 = camera_number_0(table_0);
    var width_0 : f32 = camera_number_0(table_0 + u32(1));
    if((camera_word_0(u32(2))) == u32(0))
    {
        return start_0 + u_0 * (width_0 * 32.0f);
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
    var _S24 : u32 = table_0 + u32(3);
    var probability_0 : f32 = camera_number_0(_S24 + u32(32) + bin_0);
    var place_0 : f32 = start_0 + (f32(bin_0) + min((u_0 - camera_number_0(_S24 + bin_0)) / probability_0, 1.0f)) * width_0;
    (*weight_0) = (*weight_0) * (filter_at_0(place_0) * (camera_number_0(table_0 + u32(2)) / probability_0));
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
     x_6 : f32,
     y_0 : f32,
     lens_0 : vec2<f32>,
     weight_1 : f32,
};

fn camera_sample_0( number_of_path_0 : u32) -> CameraSample_0
{
    var number_0 : u32 = input_0[i32(2)] + number_of_path_0;
    var pixels_0 : u32 = camera_word_0(u32(1));
    var columns_0 : u32 = camera_word_0(u32(0));
    var drawn_0 : CameraSample_0;
    var _S25 : u32 = number_0 % pixels_0;
    drawn_0.pixel_1 = _S25;
    var _S26 : vec2<u32> = vec2<u32>(input_0[i32(0)], input_0[i32(1)]);
    var _S27 : u32 = input_0[i32(3)];
    var _S28 : u32 = number_0 / pixels_0;
    drawn_0.key_3 = key_of_sample_0(_S26, _S25, _S27 + _S28);
    drawn_0.weight_1 = 1.0f;
    var column_0 : u32 = drawn_0.pixel_1 % columns_0;
    var row_0 : u32 = drawn_0.pixel_1 / columns_0;
    var _S29 : f32 = precise_random_0(drawn_0.key_3, u32(0));
    var _S30 : f32 = drawn_0.weight_1;
    var x_7 : f32 = along_side_0(column_0, _S29, &(_S30));
    var _S31 : u32 = columns_0 + row_0;
    var _S32 : f32 = precise_random_0(drawn_0.key_3, u32(1));
    var _S33 : f32 = _S30;
    var y_1 : f32 = along_side_0(_S31, _S32, &(_S33));
    drawn_0.weight_1 = _S33;
    drawn_0.x_6 = camera_number_0(u32(30)) - f32(column_0) - x_7;
    drawn_0.y_0 = camera_number_0(u32(31)) - f32(row_0) - y_1;
    drawn_0.lens_0 = vec2<f32>(0.0f);
    if((camera_word_0(u32(5))) != u32(0))
    {
        drawn_0.lens_0 = sine_cosine_0(6.28318548202514648f * random_0(drawn_0.key_3, u32(4))).yx * vec2<f32>(sqrt(precise_random_0(drawn_0.key_3, u32(3))));
    }
    return drawn_0;
}

fn primitive_vector_0( at_4 : u32) -> vec3<f32>
{
    return vec3<f32>(primitives_0[at_4], primitives_0[at_4 + u32(1)], primitives_0[at_4 + u32(2)]);
}

fn of_sample_0( vectors_0 : u32,  drawn_1 : CameraSample_0) -> vec3<f32>
{
    var at_5 : u32 = camera_place_0(vectors_0);
    return primitive_vector_0(at_5) + primitive_vector_0(at_5 + u32(3)) * vec3<f32>(drawn_1.x_6) + primitive_vector_0(at_5 + u32(6)) * vec3<f32>(drawn_1.y_0) + primitive_vector_0(at_5 + u32(9)) * vec3<f32>(drawn_1.lens_0.x) + primitive_vector_0(at_5 + u32(12)) * vec3<f32>(drawn_1.lens_0.y);
}

fn component_0( v_0 : vec3<f32>,  axis_0 : u32) -> f32
{
    var _S34 : f32;
    if(axis_0 == u32(0))
    {
        _S34 = v_0.x;
    }
    else
    {
        if(axis_0 == u32(1))
        {
            _S34 = v_0.y;
        }
        else
        {
            _S34 = v_0.z;
        }
    }
    return _S34;
}

fn limit_at_0( which_0 : u32) -> f32
{
    return primitives_0[word_0(u32(15)) + which_0];
}

fn change_word_0( at_6 : u32) -> u32
{
    return input_0[launch_0.room_0 + at_6];
}

fn change_vector_0( at_7 : u32) -> vec3<f32>
{
    return (bitcast<vec3<f32>>((vec3<u32>(change_word_0(at_7), change_word_0(at_7 + u32(1)), change_word_0(at_7 + u32(2))))));
}

fn change_of_sample_0( vectors_1 : u32,  drawn_2 : CameraSample_0) -> vec3<f32>
{
    var at_8 : u32 = change_word_0(u32(5)) + vectors_1;
    return change_vector_0(at_8) + change_vector_0(at_8 + u32(3)) * vec3<f32>(drawn_2.x_6) + change_vector_0(at_8 + u32(6)) * vec3<f32>(drawn_2.y_0) + change_vector_0(at_8 + u32(9)) * vec3<f32>(drawn_2.lens_0.x) + change_vector_0(at_8 + u32(12)) * vec3<f32>(drawn_2.lens_0.y);
}

fn change_of_unit_0( vector_0 : vec3<f32>,  change_0 : vec3<f32>,  size_1 : f32) -> vec3<f32>
{
    return (change_0 - vector_0 * vec3<f32>(dot(vector_0, change_0))) / vec3<f32>(size_1);
}

struct CameraRay_0
{
     start_1 : vec3<f32>,
     direction_0 : vec3<f32>,
     length_0 : f32,
     from_record_0 : f32,
     from_camera_0 : f32,
     start_change_0 : vec3<f32>,
     direction_change_0 : vec3<f32>,
};

fn camera_ray_0( drawn_3 : CameraSample_0) -> CameraRay_0
{
    var to_depth_one_0 : vec3<f32> = of_sample_0(u32(0), drawn_3);
    var recorded_0 : vec3<f32> = of_sample_0(u32(15), drawn_3);
    var size_2 : f32 = sqrt(dot(to_depth_one_0, to_depth_one_0));
    var ray_0 : CameraRay_0;
    ray_0.direction_0 = to_depth_one_0 / vec3<f32>(size_2);
    var until_0 : f32 = camera_number_0(u32(33)) * size_2;
    var enter_0 : f32 = camera_number_0(u32(32)) * size_2;
    var exit_0 : f32 = until_0;
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
        var from_0 : f32 = component_0(recorded_0, axis_1);
        var speed_0 : f32 = component_0(ray_0.direction_0, axis_1);
        var ahead_0 : f32;
        if(speed_0 != 0.0f)
        {
            if(speed_0 < 0.0f)
            {
                ahead_0 = -1.00000095367431641f;
            }
            else
            {
                ahead_0 = 1.00000095367431641f;
            }
            var _S35 : f32 = min(exit_0, (ahead_0 - from_0) / speed_0);
            enter_0 = max(enter_0, (- ahead_0 - from_0) / speed_0);
            exit_0 = _S35;
        }
        else
        {
            if((abs(from_0)) > 1.00000095367431641f)
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
        enter_0 = 0.0f;
    }
    ray_0.start_1 = recorded_0 + ray_0.direction_0 * vec3<f32>(enter_0);
    if(is_inside_0)
    {
        exit_0 = until_0 - enter_0;
    }
    else
    {
        exit_0 = -1.0f;
    }
    ray_0.length_0 = exit_0;
    ray_0.from_record_0 = enter_0;
    ray_0.from_camera_0 = camera_number_0(u32(34)) * size_2 + enter_0;
    var _S36 : vec3<f32> = change_of_unit_0(ray_0.direction_0, change_of_sample_0(u32(0), drawn_3), size_2);
    ray_0.direction_change_0 = _S36;
    ray_0.start_change_0 = change_of_sample_0(u32(15), drawn_3) + _S36 * vec3<f32>(enter_0);
    return ray_0;
}

struct Vector_0
{
     value_0 : vec3<f32>,
     change_1 : vec3<f32>,
};

fn changing_0( value_1 : vec3<f32>,  change_2 : vec3<f32>) -> Vector_0
{
    var vector_1 : Vector_0;
    vector_1.value_0 = value_1;
    vector_1.change_1 = change_2;
    return vector_1;
}

fn still_0( value_2 : vec3<f32>) -> Vector_0
{
    return changing_0(value_2, vec3<f32>(0.0f));
}

struct Ray_0
{
     origin_0 : vec3<f32>,
     shear_x_0 : f32,
     shear_y_0 : f32,
     inverse_z_0 : f32,
     t_min_0 : f32,
     t_max_0 : f32,
     local_per_t_0 : f32,
     enter_1 : f32,
     edge_on_0 : f32,
     largest_0 : f32,
};

fn ray_along_0( origin_1 : vec3<f32>,  direction_1 : vec3<f32>,  t_min_1 : f32,  t_max_1 : f32,  axes_0 : ptr<function, u32>) -> Ray_0
{
    var size_3 : vec3<f32> = abs(direction_1);
    var _S37 : f32 = size_3.x;
    var _S38 : f32 = size_3.y;
    var _S39 : bool;
    if(_S37 >= _S38)
    {
        _S39 = _S37 >= (size_3.z);
    }
    else
    {
        _S39 = false;
    }
    var _S40 : i32;
    if(_S39)
    {
        _S40 = i32(0);
    }
    else
    {
        if(_S38 >= (size_3.z))
        {
            _S40 = i32(1);
        }
        else
        {
            _S40 = i32(2);
        }
    }
    var z_1 : u32 = u32(_S40);
    var x_8 : u32 = (z_1 + u32(1)) % u32(3);
    var y_2 : u32 = (z_1 + u32(2)) % u32(3);
    (*axes_0) = (((x_8 | (((y_2 << (u32(2))))))) | (((z_1 << (u32(4))))));
    var ray_1 : Ray_0;
    ray_1.origin_0 = origin_1;
    var along_0 : f32 = component_0(direction_1, z_1);
    ray_1.inverse_z_0 = 1.0f / along_0;
    ray_1.shear_x_0 = component_0(direction_1, x_8) / along_0;
    ray_1.shear_y_0 = component_0(direction_1, y_2) / along_0;
    ray_1.t_min_0 = t_min_1;
    ray_1.t_max_0 = t_max_1;
    ray_1.local_per_t_0 = abs(along_0);
    ray_1.enter_1 = 0.0f;
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
    var _S41 : u32 = u32(14) * node_1 + slot_1 / u32(4);
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
        var _S42 : u32 = axis_2;
        var _S43 : u32 = _S41 + u32(2) * axis_2;
        var _S44 : u32 = slot_1 % u32(4);
        var low_3 : f32 = (bitcast<f32>((nodes_0[_S43][_S44])));
        var high_0 : f32 = (bitcast<f32>((nodes_0[_S43 + u32(6)][_S44])));
        var _S45 : bool = (view_0.inverse_0[axis_2]) < 0.0f;
        var _S46 : f32;
        if(_S45)
        {
            _S46 = high_0;
        }
        else
        {
            _S46 = low_3;
        }
        var _S47 : f32 = max(near_0, _S46 * view_0.inverse_0[_S42] - view_0.offset_near_0[axis_2]);
        var _S48 : f32;
        if(_S45)
        {
            _S48 = low_3;
        }
        else
        {
            _S48 = high_0;
        }
        var _S49 : f32 = min(far_0, _S48 * view_0.inverse_0[_S42] - view_0.offset_far_0[axis_2]);
        var _S50 : u32 = axis_2 + u32(1);
        near_0 = _S47;
        far_0 = _S49;
        axis_2 = _S50;
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
        var _S51 : u32 = k_0;
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
            var _S52 : u32 = j_0;
            var _S53 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S51]))
            {
                _S53 = true;
            }
            else
            {
                if((bounds_0[_S52]) == (bounds_0[_S51]))
                {
                    _S53 = j_0 < k_0;
                }
                else
                {
                    _S53 = false;
                }
            }
            if(_S53)
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
        var _S54 : f32;
        if((ray_child_0(node_2, slot_2)) == u32(4294967295))
        {
            _S54 = 3.00000000549775576e+38f;
        }
        else
        {
            _S54 = ray_bound_0(view_1, limit_3, node_2, slot_2);
        }
        bounds_1[slot_2] = _S54;
        slot_2 = slot_2 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn rounded_0( product_1 : f32,  largest_1 : f32) -> f32
{
    return min(product_1, largest_1);
}

fn corner_0( ray_2 : Ray_0,  axes_2 : u32,  at_9 : u32) -> vec3<f32>
{
    var relative_0 : vec3<f32> = primitive_vector_0(at_9) - ray_2.origin_0;
    var z_2 : f32 = component_0(relative_0, (axes_2 >> (u32(4))));
    return vec3<f32>(component_0(relative_0, (axes_2 & (u32(3)))) - rounded_0(ray_2.shear_x_0 * z_2, ray_2.largest_0), component_0(relative_0, (((axes_2 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_2.shear_y_0 * z_2, ray_2.largest_0), z_2);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_0 : f32,
     v_1 : f32,
     w_0 : f32,
};

fn intersect_0( ray_3 : Ray_0,  axes_3 : u32,  at_10 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_0 = 0.0f;
    crossing_0.v_1 = 0.0f;
    crossing_0.w_0 = 0.0f;
    var a_3 : vec3<f32> = corner_0(ray_3, axes_3, at_10);
    var b_3 : vec3<f32> = corner_0(ray_3, axes_3, at_10 + u32(3));
    var c_0 : vec3<f32> = corner_0(ray_3, axes_3, at_10 + u32(6));
    var _S55 : f32 = c_0.x;
    var _S56 : f32 = b_3.y;
    var cx_by_0 : f32 = rounded_0(_S55 * _S56, ray_3.largest_0);
    var _S57 : f32 = c_0.y;
    var _S58 : f32 = b_3.x;
    var cy_bx_0 : f32 = rounded_0(_S57 * _S58, ray_3.largest_0);
    var _S59 : f32 = a_3.x;
    var ax_cy_0 : f32 = rounded_0(_S59 * _S57, ray_3.largest_0);
    var _S60 : f32 = a_3.y;
    var ay_cx_0 : f32 = rounded_0(_S60 * _S55, ray_3.largest_0);
    var bx_ay_0 : f32 = rounded_0(_S58 * _S60, ray_3.largest_0);
    var by_ax_0 : f32 = rounded_0(_S56 * _S59, ray_3.largest_0);
    var u_1 : f32 = cx_by_0 - cy_bx_0;
    var v_2 : f32 = ax_cy_0 - ay_cx_0;
    var w_1 : f32 = bx_ay_0 - by_ax_0;
    var _S61 : f32 = min(min(u_1, v_2), w_1);
    var _S62 : f32 = max(max(u_1, v_2), w_1);
    var _S63 : bool;
    if(_S61 < 0.0f)
    {
        _S63 = _S62 > 0.0f;
    }
    else
    {
        _S63 = false;
    }
    if(_S63)
    {
        return crossing_0;
    }
    var determinant_0 : f32 = u_1 + v_2 + w_1;
    if(_S61 <= 0.0f)
    {
        _S63 = _S62 >= 0.0f;
    }
    else
    {
        _S63 = false;
    }
    if(_S63)
    {
        if((abs(determinant_0)) <= (ray_3.edge_on_0 * (abs(cx_by_0) + abs(cy_bx_0) + abs(ax_cy_0) + abs(ay_cx_0) + abs(bx_ay_0) + abs(by_ax_0))))
        {
            return crossing_0;
        }
    }
    if(determinant_0 == 0.0f)
    {
        return crossing_0;
    }
    var t_1 : f32 = (rounded_0(u_1 * a_3.z, ray_3.largest_0) + rounded_0(v_2 * b_3.z, ray_3.largest_0) + rounded_0(w_1 * c_0.z, ray_3.largest_0)) / determinant_0 * ray_3.inverse_z_0;
    if((ray_3.t_min_0) <= t_1)
    {
        _S63 = t_1 <= (ray_3.t_max_0);
    }
    else
    {
        _S63 = false;
    }
    crossing_0.is_hit_0 = _S63;
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
     v_3 : f32,
     w_2 : f32,
};

fn first_found_0( view_2 : RayView_0,  ray_4 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S64 : bool;
    var found_0 : Found_0;
    found_0.face_1 = u32(4294967295);
    found_0.triangle_1 = u32(4294967295);
    found_0.v_3 = 0.0f;
    found_0.w_2 = 0.0f;
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
        var _S65 : u32 = way_0[level_0].y;
        if(_S65 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S66 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S66;
            continue;
        }
        var slot_3 : u32 = ((_S65 & (u32(15)))) - u32(1);
        way_0[level_0][i32(1)] = (_S65 >> (u32(4)));
        var _S67 : bool;
        if(!is_new_1)
        {
            _S67 = (ray_bound_0(view_2, limit_4, here_0.x, slot_3)) > limit_4;
        }
        else
        {
            _S67 = false;
        }
        if(_S67)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_0.x, slot_3);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S68 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S68;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S69 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S70 : u32 = leaf_starts_0[leaf_0];
        var limit_5 : f32 = limit_4;
        var i_0 : u32 = _S70;
        for(;;)
        {
            if(i_0 < _S69)
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
                _S64 = true;
            }
            else
            {
                _S64 = (crossing_1.t_0) < ((*ray_4).t_max_0);
            }
            var _S71 : bool;
            if(_S64)
            {
                _S71 = true;
            }
            else
            {
                _S71 = (face_0(i_0)) < (found_0.face_1);
            }
            var limit_6 : f32;
            if(_S71)
            {
                found_0.face_1 = face_0(i_0);
                found_0.triangle_1 = i_0;
                (*ray_4).t_max_0 = crossing_1.t_0;
                found_0.v_3 = crossing_1.v_1;
                found_0.w_2 = crossing_1.w_0;
                limit_6 = min(limit_5, crossing_1.t_0 * (*ray_4).local_per_t_0 - (*ray_4).enter_1 + 2.0f * view_2.margin_0);
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
            _S64 = (found_0.face_1) != u32(4294967295);
        }
        else
        {
            _S64 = false;
        }
        if(_S64)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_0;
}

fn cast_0( origin_2 : vec3<f32>,  direction_2 : vec3<f32>,  t_min_2 : f32,  t_max_2 : f32,  any_1 : bool,  t_2 : ptr<function, f32>) -> Found_0
{
    var view_3 : RayView_0;
    var _S72 : u32 = view_3.axes_1;
    var _S73 : Ray_0 = ray_along_0(origin_2, direction_2, t_min_2, t_max_2, &(_S72));
    view_3.axes_1 = _S72;
    var ray_5 : Ray_0 = _S73;
    var _S74 : vec3<f32> = direction_2 / vec3<f32>(ray_5.local_per_t_0);
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
        var _S75 : f32 = max(abs(_S74[axis_3]), 8.67361737988403547e-19f);
        var _S76 : f32;
        if((_S74[axis_3]) < 0.0f)
        {
            _S76 = -1.0f / _S75;
        }
        else
        {
            _S76 = 1.0f / _S75;
        }
        view_3.inverse_0[axis_3] = _S76;
        axis_3 = axis_3 + u32(1);
    }
    var offset_0 : vec3<f32> = origin_2 * view_3.inverse_0;
    var wider_0 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_3.inverse_0);
    view_3.offset_near_0 = offset_0 + wider_0;
    view_3.offset_far_0 = offset_0 - wider_0;
    view_3.limit_0 = min(t_max_2 * ray_5.local_per_t_0, 8.0f) + 3.814697265625e-06f;
    view_3.margin_0 = 3.814697265625e-06f;
    var found_1 : Found_0 = first_found_0(view_3, &(ray_5), any_1);
    (*t_2) = ray_5.t_max_0;
    return found_1;
}

struct Place_0
{
     triangle_2 : u32,
     v_4 : f32,
     w_3 : f32,
     v_rest_0 : f32,
     w_rest_0 : f32,
     change_3 : vec2<f32>,
};

fn exact_place_0( triangle_3 : u32,  v_5 : f32,  w_4 : f32) -> Place_0
{
    var place_1 : Place_0;
    place_1.triangle_2 = triangle_3;
    place_1.v_4 = v_5;
    place_1.w_3 = w_4;
    place_1.v_rest_0 = 0.0f;
    place_1.w_rest_0 = 0.0f;
    place_1.change_3 = vec2<f32>(0.0f);
    return place_1;
}

fn place_of_0( found_2 : Found_0) -> Place_0
{
    return exact_place_0(found_2.triangle_1, found_2.v_3, found_2.w_2);
}

fn is_moving_0() -> bool
{
    return (change_word_0(u32(0))) != u32(4294967295);
}

fn motion_of_0( triangle_4 : u32) -> u32
{
    return change_word_0(u32(0)) + u32(21) * triangle_4;
}

fn at_place_0( a_4 : vec3<f32>,  b_4 : vec3<f32>,  c_1 : vec3<f32>,  place_2 : Place_0) -> vec3<f32>
{
    return a_4 + (b_4 - a_4) * vec3<f32>(place_2.v_4) + (c_1 - a_4) * vec3<f32>(place_2.w_3);
}

fn move_place_0( place_3 : ptr<function, Place_0>,  position_change_0 : ptr<function, vec3<f32>>,  direction_3 : vec3<f32>,  drift_0 : vec3<f32>)
{
    (*position_change_0) = drift_0;
    if(!is_moving_0())
    {
        return;
    }
    var at_11 : u32 = motion_of_0((*place_3).triangle_2);
    var corner_1 : u32 = u32(9) * (*place_3).triangle_2;
    var of_material_0 : vec3<f32> = at_place_0(change_vector_0(at_11), change_vector_0(at_11 + u32(3)), change_vector_0(at_11 + u32(6)), (*place_3));
    var a_5 : vec3<f32> = primitive_vector_0(corner_1);
    var ab_0 : vec3<f32> = primitive_vector_0(corner_1 + u32(3)) - a_5;
    var ac_0 : vec3<f32> = primitive_vector_0(corner_1 + u32(6)) - a_5;
    var across_0 : vec3<f32> = cross(ab_0, ac_0);
    var _S77 : f32 = max(max(abs(across_0.x), abs(across_0.y)), abs(across_0.z));
    var normal_0 : vec3<f32> = across_0 / vec3<f32>(_S77);
    var slip_0 : vec3<f32> = drift_0 - of_material_0;
    var slip_1 : vec3<f32> = slip_0 - direction_3 * vec3<f32>((dot(normal_0, slip_0) / dot(normal_0, direction_3)));
    (*position_change_0) = of_material_0 + slip_1;
    (*place_3).change_3 = vec2<f32>(dot(slip_1, cross(ac_0, normal_0)), dot(slip_1, cross(normal_0, ab_0))) * vec2<f32>((1.0f / (dot(normal_0, normal_0) * _S77)));
    return;
}

fn triangle_record_0( triangle_5 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_5;
}

fn shape_of_0( triangle_6 : u32) -> u32
{
    return word_0(u32(10)) + u32(7) * word_0(triangle_record_0(triangle_6));
}

fn cross_of_0( triangle_7 : u32) -> vec3<f32>
{
    var at_12 : u32 = u32(9) * triangle_7;
    var a_6 : vec3<f32> = primitive_vector_0(at_12);
    return cross(primitive_vector_0(at_12 + u32(3)) - a_6, primitive_vector_0(at_12 + u32(6)) - a_6);
}

fn emitter_seen_0( found_3 : Found_0,  direction_4 : vec3<f32>) -> u32
{
    if((found_3.face_1) == u32(4294967295))
    {
        return word_0(u32(8));
    }
    var emitter_0 : u32 = word_0(shape_of_0(found_3.triangle_1) + u32(4));
    var _S78 : bool;
    if(emitter_0 != u32(4294967295))
    {
        _S78 = (dot(cross_of_0(found_3.triangle_1), direction_4)) < 0.0f;
    }
    else
    {
        _S78 = false;
    }
    var _S79 : u32;
    if(_S78)
    {
        _S79 = emitter_0;
    }
    else
    {
        _S79 = u32(4294967295);
    }
    return _S79;
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
     by_first_0 : vec4<f32>,
     by_second_0 : vec4<f32>,
};

fn one_texel_0( texel_0 : u32) -> Lookup_0
{
    var lookup_0 : Lookup_0;
    lookup_0.count_0 = u32(1);
    lookup_0.texels_0 = vec4<u32>(texel_0, u32(0), u32(0), u32(0));
    lookup_0.weights_0 = vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f);
    var _S80 : vec4<f32> = vec4<f32>(0.0f);
    lookup_0.by_second_0 = _S80;
    lookup_0.by_first_0 = _S80;
    return lookup_0;
}

struct Corners2_0
{
     a_7 : vec2<f32>,
     b_5 : vec2<f32>,
     c_2 : vec2<f32>,
};

fn Corners2_x24init_0( a_8 : vec2<f32>,  b_6 : vec2<f32>,  c_3 : vec2<f32>) -> Corners2_0
{
    var _S81 : Corners2_0;
    _S81.a_7 = a_8;
    _S81.b_5 = b_6;
    _S81.c_2 = c_3;
    return _S81;
}

fn number_1( at_13 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_13])));
}

fn precise_0( at_14 : u32) -> f32
{
    return number_1(at_14) + number_1(at_14 + u32(1));
}

fn uvs_of_0( triangle_8 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f32>(0.0f, 0.0f), vec2<f32>(1.0f, 0.0f), vec2<f32>(0.0f, 1.0f));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_8) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_15 : u32 = uvs_at_0 + u32(12) * word_0(triangle_record_0(triangle_8) + u32(1));
    uvs_0.a_7 = vec2<f32>(precise_0(at_15), precise_0(at_15 + u32(2)));
    uvs_0.b_5 = vec2<f32>(precise_0(at_15 + u32(4)), precise_0(at_15 + u32(6)));
    uvs_0.c_2 = vec2<f32>(precise_0(at_15 + u32(8)), precise_0(at_15 + u32(10)));
    return uvs_0;
}

fn row_at_0( at_16 : u32) -> vec3<f32>
{
    return vec3<f32>(precise_0(at_16), precise_0(at_16 + u32(2)), precise_0(at_16 + u32(4)));
}

fn floor_of_0( x_9 : f32) -> i32
{
    return i32(clamp(floor(x_9), -1.0e+09f, 1.0e+09f));
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
     value_3 : vec2<f32>,
     by_first_1 : vec2<f32>,
     by_second_1 : vec2<f32>,
};

fn between_0( texels_1 : vec4<u32>,  place_4 : Point_0) -> Lookup_0
{
    var way_1 : vec2<f32> = place_4.value_3 - floor(place_4.value_3);
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - way_1;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S82 : f32 = back_0.x;
    var _S83 : f32 = back_0.y;
    var _S84 : f32 = way_1.x;
    var _S85 : f32 = way_1.y;
    lookup_1.weights_0 = vec4<f32>(_S82 * _S83, _S84 * _S83, _S82 * _S85, _S84 * _S85);
    var by_x_0 : vec4<f32> = vec4<f32>(- _S83, _S83, - _S85, _S85);
    var by_y_0 : vec4<f32> = vec4<f32>(- _S82, - _S84, _S82, _S84);
    lookup_1.by_first_0 = by_x_0 * vec4<f32>(place_4.by_first_1.x) + by_y_0 * vec4<f32>(place_4.by_first_1.y);
    lookup_1.by_second_0 = by_x_0 * vec4<f32>(place_4.by_second_1.x) + by_y_0 * vec4<f32>(place_4.by_second_1.y);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_1 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var size_4 : vec2<f32> = vec2<f32>(f32(width_1), f32(height_0));
    var place_5 : vec2<f32> = uv_0.value_3 * size_4;
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_1 : u32 = wrapped_0(floor_of_0(place_5.y), height_0, wrap_1);
        var _S86 : u32 = row_1 * u32(width_1);
        var _S87 : u32 = wrapped_0(floor_of_0(place_5.x), width_1, wrap_1);
        return one_texel_0(_S86 + _S87);
    }
    var centred_0 : Point_0;
    var _S88 : vec2<f32> = place_5 - vec2<f32>(0.5f);
    centred_0.value_3 = _S88;
    centred_0.by_first_1 = uv_0.by_first_1 * size_4;
    centred_0.by_second_1 = uv_0.by_second_1 * size_4;
    var x_10 : i32 = floor_of_0(_S88.x);
    var y_3 : i32 = floor_of_0(_S88.y);
    var _S89 : u32 = wrapped_0(y_3, height_0, wrap_1);
    var _S90 : u32 = u32(width_1);
    var first_2 : u32 = _S89 * _S90;
    var _S91 : u32 = wrapped_0(y_3 + i32(1), height_0, wrap_1);
    var second_1 : u32 = _S91 * _S90;
    var left_0 : u32 = wrapped_0(x_10, width_1, wrap_1);
    var right_0 : u32 = wrapped_0(x_10 + i32(1), width_1, wrap_1);
    return between_0(vec4<u32>(first_2 + left_0, first_2 + right_0, second_1 + left_0, second_1 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_6 : Place_0) -> Lookup_0
{
    var kind_1 : u32 = word_0(texture_1);
    if(kind_1 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_1 : u32 = triangle_record_0(place_6.triangle_2) + u32(1);
    if(kind_1 == u32(4))
    {
        return one_texel_0(word_0(record_1));
    }
    if(kind_1 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_1 + u32(1)), word_0(record_1 + u32(2)), word_0(record_1 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_6.v_4 - place_6.w_3, place_6.v_4, place_6.w_3, 0.0f);
        lookup_2.by_first_0 = vec4<f32>(-1.0f, 1.0f, 0.0f, 0.0f);
        lookup_2.by_second_0 = vec4<f32>(-1.0f, 0.0f, 1.0f, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_6.triangle_2);
    var by_v_0 : vec2<f32> = uvs_1.b_5 - uvs_1.a_7;
    var by_w_0 : vec2<f32> = uvs_1.c_2 - uvs_1.a_7;
    var _S92 : u32 = texture_1 + u32(6);
    var to_u_0 : vec3<f32> = row_at_0(_S92);
    var to_v_0 : vec3<f32> = row_at_0(_S92 + u32(6));
    var uv_1 : Point_0;
    var _S93 : vec3<f32> = vec3<f32>(uvs_1.a_7 + by_v_0 * vec2<f32>((place_6.v_4 + place_6.v_rest_0)) + by_w_0 * vec2<f32>((place_6.w_3 + place_6.w_rest_0)), 1.0f);
    uv_1.value_3 = vec2<f32>(dot(_S93, to_u_0), dot(_S93, to_v_0));
    var _S94 : vec2<f32> = to_u_0.xy;
    var _S95 : vec2<f32> = to_v_0.xy;
    uv_1.by_first_1 = vec2<f32>(dot(by_v_0, _S94), dot(by_v_0, _S95));
    uv_1.by_second_1 = vec2<f32>(dot(by_w_0, _S94), dot(by_w_0, _S95));
    if(kind_1 == u32(1))
    {
        var _S96 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S96;
    }
    var half_of_period_0 : vec2<f32> = uv_1.value_3 - floor(uv_1.value_3);
    var _S97 : i32;
    if(((half_of_period_0.x) > 0.5f) != ((half_of_period_0.y) > 0.5f))
    {
        _S97 = i32(1);
    }
    else
    {
        _S97 = i32(0);
    }
    return one_texel_0(u32(_S97));
}

fn vector_at_0( at_17 : u32) -> vec3<f32>
{
    return vec3<f32>(number_1(at_17), number_1(at_17 + u32(1)), number_1(at_17 + u32(2)));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_1 : vec4<f32>) -> vec3<f32>
{
    var _S98 : u32 = word_0(texture_2 + u32(1));
    var _S99 : u32 = texture_2 + u32(19);
    var _S100 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_4 : vec3<f32> = _S100;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_18 : u32 = _S99 + _S98 * lookup_3.texels_0[k_1];
        var _S101 : vec3<f32>;
        if(_S98 == u32(1))
        {
            _S101 = vec3<f32>(number_1(at_18));
        }
        else
        {
            _S101 = vector_at_0(at_18);
        }
        var value_5 : vec3<f32> = value_4 + _S101 * vec3<f32>(weights_1[k_1]);
        k_1 = k_1 + u32(1);
        value_4 = value_5;
    }
    return value_4;
}

fn numbers_of_0( texture_3 : u32) -> u32
{
    return change_word_0(u32(7) + word_0(texture_3 + u32(18)));
}

fn looked_up_0( texture_4 : u32,  lookup_4 : Lookup_0,  place_change_0 : vec2<f32>) -> Vector_0
{
    var value_6 : vec3<f32> = weighted_texels_0(texture_4, lookup_4, lookup_4.weights_0);
    var change_4 : vec3<f32> = weighted_texels_0(texture_4, lookup_4, lookup_4.by_first_0 * vec4<f32>(place_change_0.x) + lookup_4.by_second_0 * vec4<f32>(place_change_0.y));
    var first_3 : u32 = numbers_of_0(texture_4);
    if(first_3 == u32(4294967295))
    {
        return changing_0(value_6, change_4);
    }
    var _S102 : bool = (word_0(texture_4 + u32(1))) == u32(1);
    var k_2 : u32 = u32(0);
    var change_5 : vec3<f32> = change_4;
    for(;;)
    {
        if(k_2 < (lookup_4.count_0))
        {
        }
        else
        {
            break;
        }
        var _S103 : i32;
        if(_S102)
        {
            _S103 = i32(1);
        }
        else
        {
            _S103 = i32(3);
        }
        var at_19 : u32 = first_3 + u32(_S103) * lookup_4.texels_0[k_2];
        var of_texel_0 : vec3<f32>;
        if(_S102)
        {
            of_texel_0 = (bitcast<vec3<f32>>((vec3<u32>(change_word_0(at_19)))));
        }
        else
        {
            of_texel_0 = change_vector_0(at_19);
        }
        var change_6 : vec3<f32> = change_5 + of_texel_0 * vec3<f32>(lookup_4.weights_0[k_2]);
        k_2 = k_2 + u32(1);
        change_5 = change_6;
    }
    return changing_0(value_6, change_5);
}

fn shown_0( texture_5 : u32,  place_7 : Place_0) -> Vector_0
{
    var _S104 : Lookup_0 = lookup_at_0(texture_5, place_7);
    return looked_up_0(texture_5, _S104, place_7.change_3);
}

fn angle_of_0( x_11 : f32,  y_4 : f32) -> f32
{
    var _S105 : f32 = abs(x_11);
    var _S106 : f32 = abs(y_4);
    var _S107 : f32 = min(_S105, _S106);
    var _S108 : f32 = max(_S105, _S106);
    var is_steep_0 : bool = _S107 > (0.41421356797218323f * _S108);
    var above_0 : f32;
    if(is_steep_0)
    {
        above_0 = _S107 - _S108;
    }
    else
    {
        above_0 = _S107;
    }
    var below_0 : f32;
    if(is_steep_0)
    {
        below_0 = _S107 + _S108;
    }
    else
    {
        below_0 = _S108;
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
    if(_S106 > _S105)
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

fn s_fwd_angle_of_0( dpx_5 : DiffPair_float_0,  dpy_2 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S109 : DiffPair_float_0 = DiffPair_float_0( dpx_5.primal_0, dpx_5.differential_0 );
    var _S110 : DiffPair_float_0 = _d_abs_0(_S109);
    var _S111 : DiffPair_float_0 = DiffPair_float_0( dpy_2.primal_0, dpy_2.differential_0 );
    var _S112 : DiffPair_float_0 = _d_abs_0(_S111);
    var _S113 : DiffPair_float_0 = DiffPair_float_0( _S110.primal_0, _S110.differential_0 );
    var _S114 : DiffPair_float_0 = DiffPair_float_0( _S112.primal_0, _S112.differential_0 );
    var _S115 : DiffPair_float_0 = _d_min_0(_S113, _S114);
    var _S116 : DiffPair_float_0 = _d_max_0(_S113, _S114);
    var is_steep_1 : bool = (_S115.primal_0) > (0.41421356797218323f * _S116.primal_0);
    var above_1 : f32;
    var s_diff_above_0 : f32;
    if(is_steep_1)
    {
        var _S117 : f32 = _S115.differential_0 - _S116.differential_0;
        above_1 = _S115.primal_0 - _S116.primal_0;
        s_diff_above_0 = _S117;
    }
    else
    {
        above_1 = _S115.primal_0;
        s_diff_above_0 = _S115.differential_0;
    }
    var below_1 : f32;
    var s_diff_below_0 : f32;
    if(is_steep_1)
    {
        var _S118 : f32 = _S115.differential_0 + _S116.differential_0;
        below_1 = _S115.primal_0 + _S116.primal_0;
        s_diff_below_0 = _S118;
    }
    else
    {
        below_1 = _S116.primal_0;
        s_diff_below_0 = _S116.differential_0;
    }
    if(below_1 > 0.0f)
    {
    }
    else
    {
        below_1 = 1.0f;
        s_diff_below_0 = 0.0f;
    }
    var t_4 : f32 = above_1 / below_1;
    var s_diff_t_0 : f32 = (s_diff_above_0 * below_1 - above_1 * s_diff_below_0) / (below_1 * below_1);
    var z_4 : f32 = t_4 * t_4;
    var _S119 : f32 = s_diff_t_0 * t_4;
    var s_diff_z_0 : f32 = _S119 + _S119;
    var _S120 : f32 = 0.08053744584321976f * z_4 - 0.13877685368061066f;
    var _S121 : f32 = _S120 * z_4 + 0.19977711141109467f;
    var tail_0 : f32 = _S121 * z_4 - 0.33332949876785278f;
    var _S122 : f32 = tail_0 * z_4;
    var angle_3 : f32 = _S122 * t_4 + t_4;
    var s_diff_angle_0 : f32 = (((s_diff_z_0 * 0.08053744584321976f * z_4 + s_diff_z_0 * _S120) * z_4 + s_diff_z_0 * _S121) * z_4 + s_diff_z_0 * tail_0) * t_4 + s_diff_t_0 * _S122 + s_diff_t_0;
    var angle_4 : f32;
    if(is_steep_1)
    {
        angle_4 = angle_3 + 0.78539818525314331f;
    }
    else
    {
        angle_4 = angle_3;
    }
    var s_diff_angle_1 : f32;
    if((_S112.primal_0) > (_S110.primal_0))
    {
        var _S123 : f32 = 0.0f - s_diff_angle_0;
        angle_4 = 1.57079637050628662f - angle_4;
        s_diff_angle_1 = _S123;
    }
    else
    {
        s_diff_angle_1 = s_diff_angle_0;
    }
    if((dpx_5.primal_0) < 0.0f)
    {
        var _S124 : f32 = 0.0f - s_diff_angle_1;
        angle_4 = 3.14159274101257324f - angle_4;
        s_diff_angle_1 = _S124;
    }
    if((dpy_2.primal_0) < 0.0f)
    {
        var _S125 : f32 = - s_diff_angle_1;
        above_1 = - angle_4;
        s_diff_above_0 = _S125;
    }
    else
    {
        above_1 = angle_4;
        s_diff_above_0 = s_diff_angle_1;
    }
    var _S126 : DiffPair_float_0 = DiffPair_float_0( above_1, s_diff_above_0 );
    return _S126;
}

fn map_place_0( map_0 : u32,  direction_5 : vec3<f32>) -> vec2<f32>
{
    var _S127 : u32 = map_0 + u32(2);
    var d_0 : vec3<f32> = vector_at_0(_S127) * vec3<f32>(direction_5.x) + vector_at_0(_S127 + u32(3)) * vec3<f32>(direction_5.y) + vector_at_0(_S127 + u32(6)) * vec3<f32>(direction_5.z);
    return vec2<f32>(angle_of_0(- d_0.z, d_0.x) * 0.15915493667125702f * f32(word_0(map_0)) - 0.5f, angle_of_0(d_0.y, length(d_0.xz)) * 0.31830987334251404f * (f32(word_0(map_0 + u32(1))) - 1.0f));
}

struct DiffPair_vectorx3Cfloatx2C3x3E_0
{
     primal_0 : vec3<f32>,
     differential_0 : vec3<f32>,
};

fn s_fwd_map_place_0( map_1 : u32,  dpdirection_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C2x3E_0
{
    var _S128 : u32 = map_1 + u32(2);
    var _S129 : vec3<f32> = vector_at_0(_S128);
    var _S130 : vec3<f32> = vector_at_0(_S128 + u32(3));
    var _S131 : vec3<f32> = vector_at_0(_S128 + u32(6));
    var d_1 : vec3<f32> = _S129 * vec3<f32>(dpdirection_0.primal_0.x) + _S130 * vec3<f32>(dpdirection_0.primal_0.y) + _S131 * vec3<f32>(dpdirection_0.primal_0.z);
    var s_diff_d_0 : vec3<f32> = vec3<f32>(dpdirection_0.differential_0.x) * _S129 + vec3<f32>(dpdirection_0.differential_0.y) * _S130 + vec3<f32>(dpdirection_0.differential_0.z) * _S131;
    var _S132 : DiffPair_float_0 = DiffPair_float_0( - d_1.z, - s_diff_d_0.z );
    var _S133 : DiffPair_float_0 = DiffPair_float_0( d_1.x, s_diff_d_0.x );
    var _S134 : DiffPair_float_0 = s_fwd_angle_of_0(_S132, _S133);
    var _S135 : DiffPair_vectorx3Cfloatx2C2x3E_0 = DiffPair_vectorx3Cfloatx2C2x3E_0( d_1.xz, s_diff_d_0.xz );
    var _S136 : DiffPair_float_0 = s_fwd_length_impl_0(_S135);
    var _S137 : DiffPair_float_0 = DiffPair_float_0( d_1.y, s_diff_d_0.y );
    var _S138 : DiffPair_float_0 = DiffPair_float_0( _S136.primal_0, _S136.differential_0 );
    var _S139 : DiffPair_float_0 = s_fwd_angle_of_0(_S137, _S138);
    var width_2 : f32 = f32(word_0(map_1));
    var _S140 : f32 = f32(word_0(map_1 + u32(1))) - 1.0f;
    var _S141 : DiffPair_vectorx3Cfloatx2C2x3E_0 = DiffPair_vectorx3Cfloatx2C2x3E_0( vec2<f32>(_S134.primal_0 * 0.15915493667125702f * width_2 - 0.5f, _S139.primal_0 * 0.31830987334251404f * _S140), vec2<f32>(_S134.differential_0 * 0.15915493667125702f * width_2, _S139.differential_0 * 0.31830987334251404f * _S140) );
    return _S141;
}

fn value_of_0( vector_2 : Vector_0) -> vec3<f32>
{
    return vector_2.value_0;
}

fn in_map_0( map_2 : u32,  direction_6 : vec3<f32>) -> Lookup_0
{
    var place_8 : vec2<f32> = map_place_0(map_2, direction_6);
    var point_0 : Point_0;
    point_0.value_3 = place_8;
    point_0.by_first_1 = vec2<f32>(1.0f, 0.0f);
    point_0.by_second_1 = vec2<f32>(0.0f, 1.0f);
    var x_12 : i32 = floor_of_0(place_8.x);
    var y_5 : i32 = floor_of_0(place_8.y);
    var width_3 : i32 = i32(word_0(map_2));
    var height_1 : i32 = i32(word_0(map_2 + u32(1)));
    var left_1 : u32 = wrapped_0(x_12, width_3, u32(0));
    var right_1 : u32 = wrapped_0(x_12 + i32(1), width_3, u32(0));
    var _S142 : u32 = wrapped_0(y_5, height_1, u32(2));
    var _S143 : u32 = u32(width_3);
    var first_4 : u32 = _S142 * _S143;
    var _S144 : u32 = wrapped_0(y_5 + i32(1), height_1, u32(2));
    var second_2 : u32 = _S144 * _S143;
    return between_0(vec4<u32>(first_4 + left_1, first_4 + right_1, second_2 + left_1, second_2 + right_1), point_0);
}

fn x2A_0( a_9 : Vector_0,  b_7 : Vector_0) -> Vector_0
{
    return changing_0(a_9.value_0 * b_7.value_0, a_9.change_1 * b_7.value_0 + a_9.value_0 * b_7.change_1);
}

fn emitted_0( emitter_2 : u32,  place_9 : Place_0,  direction_7 : Vector_0) -> Vector_0
{
    var record_2 : u32 = emitter_record_0(emitter_2);
    var texture_6 : u32 = word_0(record_2 + u32(1));
    if(!is_map_0(record_2))
    {
        var _S145 : Vector_0 = shown_0(texture_6, place_9);
        return _S145;
    }
    var _S146 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( direction_7.value_0, direction_7.change_1 );
    var _S147 : DiffPair_vectorx3Cfloatx2C2x3E_0 = s_fwd_map_place_0(texture_6, _S146);
    var factor_0 : Vector_0 = looked_up_0(word_0(texture_6 + u32(12)), one_texel_0(u32(0)), vec2<f32>(0.0f));
    var _S148 : u32 = word_0(texture_6 + u32(11));
    var _S149 : Lookup_0 = in_map_0(texture_6, value_of_0(direction_7));
    return x2A_0(looked_up_0(_S148, _S149, _S147.differential_0), factor_0);
}

fn reaches_0( segments_0 : u32) -> bool
{
    return segments_0 <= (word_0(u32(0)));
}

struct Path_0
{
     throughput_0 : Vector_0,
     direction_8 : Vector_0,
     place_10 : Place_0,
     key_4 : vec2<u32>,
     light_0 : Vector_0,
     drift_1 : vec3<f32>,
     walked_0 : vec3<f32>,
     divergence_0 : f32,
};

fn begin_0( number_of_path_1 : u32,  path_0 : ptr<function, Path_0>) -> bool
{
    var drawn_4 : CameraSample_0 = camera_sample_0(number_of_path_1);
    var ray_6 : CameraRay_0 = camera_ray_0(drawn_4);
    (*path_0).key_4 = drawn_4.key_3;
    (*path_0).throughput_0 = still_0(vec3<f32>(1.0f));
    atomicStore(&(sums_0[u32(4) + number_of_path_1]), (bitcast<u32>((drawn_4.weight_1))));
    var t_5 : f32 = 0.0f;
    var found_4 : Found_0;
    found_4.face_1 = u32(4294967295);
    found_4.triangle_1 = u32(0);
    found_4.v_3 = 0.0f;
    found_4.w_2 = 0.0f;
    var _S150 : bool;
    if((ray_6.length_0) >= 0.0f)
    {
        _S150 = (word_0(u32(14))) != u32(0);
    }
    else
    {
        _S150 = false;
    }
    if(_S150)
    {
        var _S151 : Found_0 = cast_0(ray_6.start_1, ray_6.direction_0, 0.0f, ray_6.length_0, false, &(t_5));
        found_4 = _S151;
    }
    var _S152 : Place_0 = place_of_0(found_4);
    (*path_0).place_10 = _S152;
    var seen_0 : Place_0 = _S152;
    var _S153 : vec3<f32> = vec3<f32>(0.0f);
    (*path_0).walked_0 = _S153;
    (*path_0).divergence_0 = 0.0f;
    (*path_0).direction_8 = changing_0(ray_6.direction_0, ray_6.direction_change_0);
    (*path_0).drift_1 = ray_6.start_change_0 + ray_6.direction_change_0 * vec3<f32>(t_5);
    var unused_0 : vec3<f32>;
    if((found_4.face_1) != u32(4294967295))
    {
        move_place_0(&(seen_0), &(unused_0), ray_6.direction_0, (*path_0).drift_1);
    }
    var _S154 : Vector_0 = still_0(_S153);
    var emitter_3 : u32 = emitter_seen_0(found_4, ray_6.direction_0);
    if(emitter_3 != u32(4294967295))
    {
        _S150 = (word_0(u32(4))) != u32(0);
    }
    else
    {
        _S150 = false;
    }
    var light_1 : Vector_0;
    if(_S150)
    {
        var _S155 : Vector_0 = emitted_0(emitter_3, seen_0, (*path_0).direction_8);
        light_1 = _S155;
    }
    else
    {
        light_1 = _S154;
    }
    (*path_0).light_0 = light_1;
    if((found_4.face_1) != u32(4294967295))
    {
        _S150 = reaches_0(u32(2));
    }
    else
    {
        _S150 = false;
    }
    return _S150;
}

fn set_word_0( path_1 : u32,  which_1 : u32,  value_7 : u32)
{
    paths_0[which_1 * launch_0.room_0 + path_1] = value_7;
    return;
}

fn set_vector_0( path_2 : u32,  which_2 : ptr<function, u32>,  value_8 : vec3<f32>)
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
        set_word_0(path_2, (*which_2) + axis_4, (bitcast<u32>((value_8[axis_4]))));
        axis_4 = axis_4 + u32(1);
    }
    (*which_2) = (*which_2) + u32(3);
    return;
}

fn set_vector_1( path_3 : u32,  which_3 : ptr<function, u32>,  value_9 : vec3<f32>)
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
        set_word_0(path_3, (*which_3) + axis_5, (bitcast<u32>((value_9[axis_5]))));
        axis_5 = axis_5 + u32(1);
    }
    (*which_3) = (*which_3) + u32(3);
    return;
}

fn change_of_0( vector_3 : Vector_0) -> vec3<f32>
{
    return vector_3.change_1;
}

fn set_changing_0( path_4 : u32,  which_4 : ptr<function, u32>,  vector_4 : Vector_0)
{
    set_vector_1(path_4, &((*which_4)), value_of_0(vector_4));
    set_vector_1(path_4, &((*which_4)), change_of_0(vector_4));
    return;
}

fn set_place_0( path_5 : u32,  which_5 : ptr<function, u32>,  place_11 : Place_0)
{
    set_word_0(path_5, (*which_5), place_11.triangle_2);
    set_word_0(path_5, (*which_5) + u32(1), (bitcast<u32>((place_11.v_4))));
    set_word_0(path_5, (*which_5) + u32(2), (bitcast<u32>((place_11.w_3))));
    set_word_0(path_5, (*which_5) + u32(3), (bitcast<u32>((place_11.v_rest_0))));
    set_word_0(path_5, (*which_5) + u32(4), (bitcast<u32>((place_11.w_rest_0))));
    (*which_5) = (*which_5) + u32(5);
    return;
}

fn store_0( number_of_path_2 : u32,  path_6 : Path_0)
{
    var at_20 : u32 = u32(1);
    set_changing_0(number_of_path_2, &(at_20), path_6.light_0);
    set_changing_0(number_of_path_2, &(at_20), path_6.throughput_0);
    set_changing_0(number_of_path_2, &(at_20), path_6.direction_8);
    set_vector_0(number_of_path_2, &(at_20), path_6.drift_1);
    set_place_0(number_of_path_2, &(at_20), path_6.place_10);
    var _S156 : u32 = at_20 + u32(1);
    set_word_0(number_of_path_2, at_20, path_6.key_4.x);
    at_20 = _S156 + u32(1);
    set_word_0(number_of_path_2, _S156, path_6.key_4.y);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S157 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S158 : u32 = u32(2) + zero_0;
        _S157 = _S158;
        if(rounds_0 < _S158)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S157;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S159 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn begin_forward(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var number_of_path_3 : u32 = launch_0.first_0 + thread_0.x;
    if(number_of_path_3 >= (launch_0.end_0))
    {
        return;
    }
    var path_7 : Path_0;
    var goes_on_0 : bool = begin_0(number_of_path_3, &(path_7));
    store_0(number_of_path_3, path_7);
    var _S160 : u32;
    if(goes_on_0)
    {
        _S160 = number_of_path_3;
    }
    else
    {
        _S160 = u32(4294967295);
    }
    set_word_0(number_of_path_3, u32(0), _S160);
    check_loops_0();
    return;
}
