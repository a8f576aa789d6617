// Compiled from boundary.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: e17d2c6c7dee079f
// result: 5a7023c39d37c749

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) room_0 : u32,
    @align(4) depth_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(5) @group(0) var<storage, read> input_0 : array<u32>;

@binding(6) @group(0) var<storage, read_write> paths_0 : array<u32>;

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

fn side_path_0( number_of_path_0 : u32,  side_0 : u32) -> u32
{
    return launch_0.room_0 / u32(3) + u32(2) * number_of_path_0 + side_0;
}

fn path_word_0( path_0 : u32,  which_0 : u32) -> u32
{
    return paths_0[which_0 * launch_0.room_0 + path_0];
}

fn path_vector_0( path_1 : u32,  which_1 : ptr<function, u32>) -> vec3<f32>
{
    var _S1 : u32 = (*which_1) + u32(3);
    (*which_1) = _S1;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_1, _S1 - u32(3)), path_word_0(path_1, _S1 - u32(2)), path_word_0(path_1, _S1 - u32(1))))));
}

fn path_vector_1( path_2 : u32,  which_2 : ptr<function, u32>) -> vec3<f32>
{
    var _S2 : u32 = (*which_2) + u32(3);
    (*which_2) = _S2;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_2, _S2 - u32(3)), path_word_0(path_2, _S2 - u32(2)), path_word_0(path_2, _S2 - u32(1))))));
}

struct Crossed_0
{
     factor_0 : vec3<f32>,
     term_0 : vec3<f32>,
     goes_on_0 : vec2<bool>,
};

fn nothing_crossed_0( factor_1 : vec3<f32>) -> Crossed_0
{
    var crossed_0 : Crossed_0;
    crossed_0.factor_0 = factor_1;
    crossed_0.goes_on_0 = vec2<bool>(false, false);
    crossed_0.term_0 = vec3<f32>(0.0f);
    return crossed_0;
}

fn set_word_0( path_3 : u32,  which_3 : u32,  value_0 : u32)
{
    paths_0[which_3 * launch_0.room_0 + path_3] = value_0;
    return;
}

fn set_vector_0( path_4 : u32,  which_4 : ptr<function, u32>,  value_1 : vec3<f32>)
{
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
        set_word_0(path_4, (*which_4) + axis_0, (bitcast<u32>((value_1[axis_0]))));
        axis_0 = axis_0 + u32(1);
    }
    (*which_4) = (*which_4) + u32(3);
    return;
}

fn add_0( number_of_path_1 : u32,  crossed_1 : Crossed_0)
{
    var change_0 : u32 = u32(4);
    var before_0 : vec3<f32> = path_vector_0(number_of_path_1, &(change_0));
    change_0 = u32(4);
    set_vector_0(number_of_path_1, &(change_0), before_0 + crossed_1.term_0);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S3 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S4 : u32 = u32(2) + zero_0;
        _S3 = _S4;
        if(rounds_0 < _S4)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S3;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S5 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn add_sides(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var listed_0 : u32 = launch_0.first_0 + thread_0.x;
    if(listed_0 >= (launch_0.end_0))
    {
        return;
    }
    var number_of_path_2 : u32 = input_0[listed_0];
    var _S6 : vec3<f32> = vec3<f32>(0.0f);
    var side_1 : u32 = u32(0);
    var sum_0 : vec3<f32> = _S6;
    for(;;)
    {
        if(side_1 < u32(2))
        {
        }
        else
        {
            break;
        }
        var number_0 : u32 = side_path_0(number_of_path_2, side_1);
        var which_5 : u32 = u32(20);
        var weight_0 : vec3<f32> = path_vector_1(number_0, &(which_5));
        which_5 = u32(1);
        if((any((weight_0 != _S6))))
        {
            var _S7 : vec3<f32> = path_vector_1(number_0, &(which_5));
            sum_0 = sum_0 + weight_0 * _S7;
        }
        side_1 = side_1 + u32(1);
    }
    var crossed_2 : Crossed_0 = nothing_crossed_0(_S6);
    crossed_2.term_0 = sum_0;
    add_0(number_of_path_2, crossed_2);
    check_loops_0();
    return;
}
